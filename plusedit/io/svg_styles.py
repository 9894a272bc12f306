"""Styles: style sheets, presentation attributes and inheritance of SVG.

Style sheets are read as far as drawing programs write them: rules for `*`, names of elements,
classes, ids and joined ones such as `path.thin#a`. Rules that depend on where an element stands
are not followed.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TypeAlias

from svgelements import Color

from plusedit.io.svg_tree import Element

Properties: TypeAlias = Mapping[str, str]

# fmt: off
INHERITED = frozenset([
    "color", "fill", "fill-opacity", "fill-rule", "stroke", "stroke-width", "stroke-opacity",
    "stroke-linecap", "stroke-linejoin", "stroke-dasharray", "visibility",
])
OWN = frozenset(["display", "opacity", "clip-path", "mask", "vector-effect", "stop-color"])
# fmt: on
INITIAL: Properties = {"fill": "black", "stroke": "none", "visibility": "visible"}

COMMENT = re.compile(r"/\*.*?(?:\*/|\Z)", re.DOTALL)
COMPOUND = re.compile(r"(\*|[\w-]+)?((?:[.#][\w-]+)*)\Z")
LONGEST_COLOR = 64  # characters
BLACK = "#000000"
CURRENT = "currentColor"
"""The color that whoever shows a drawing chooses: what the theme is to a design"""


@dataclass(frozen=True)
class Rule:
    """One rule of a style sheet."""

    tag: str
    """"" for any"""
    identity: str
    classes: frozenset[str]
    properties: Properties

    @property
    def weight(self) -> tuple[int, int, int]:
        """What decides between rules: ids, then classes, then names."""
        return bool(self.identity), len(self.classes), bool(self.tag)

    @property
    def key(self) -> str:
        """The part that fewest elements have, by which the rule is looked up."""
        if self.identity:
            return f"#{self.identity}"
        return f".{min(self.classes)}" if self.classes else self.tag or "*"

    def suits(self, element: Element) -> bool:
        """Whether the rule is for that element."""
        if self.tag and self.tag != element.tag:
            return False
        if self.identity and self.identity != element.get("id"):
            return False
        return not self.classes or self.classes <= set(element.get("class").split())


class StyleSheet:
    """All rules of a file, weakest first."""

    def __init__(self, root: Element) -> None:
        rules = [rule for text in _texts(root) for rule in _rules(text)]
        rules.sort(key=lambda rule: rule.weight)  # stable: of equal ones the later wins
        self._by_key: dict[str, list[tuple[int, Rule]]] = {}
        for number, rule in enumerate(rules):
            self._by_key.setdefault(rule.key, []).append((number, rule))

    def own(self, element: Element) -> dict[str, str]:
        """What is said of that element: attributes, then rules, then its attribute `style`."""
        names = INHERITED | OWN
        properties = {k: v.strip() for k, v in element.attributes.items() if k in names}
        classes = element.get("class").split()
        keys = ["*", element.tag, *(f".{name}" for name in classes), f"#{element.get('id')}"]
        suitable = [entry for key in dict.fromkeys(keys) for entry in self._by_key.get(key, ())]
        for _, rule in sorted(suitable, key=lambda entry: entry[0]):
            if rule.suits(element):
                properties.update(rule.properties)
        properties.update(declarations(element.get("style")))
        return properties

    def of(self, element: Element, parent: Properties) -> dict[str, str]:
        """The properties of an element whose parent has those."""
        properties = {k: v for k, v in parent.items() if k in INHERITED}
        for key, value in self.own(element).items():
            if value == "inherit":
                value = parent.get(key, "")
            if value:
                properties[key] = value
        return properties


def declarations(text: str) -> dict[str, str]:
    """`name: value` pairs between semicolons; those that are none are passed over."""
    found = {}
    for part in text.split(";"):
        name, colon, value = part.partition(":")
        if colon:
            found[name.strip().lower()] = value.replace("!important", "").strip()
    return found


def _texts(element: Element) -> list[str]:
    texts = [element.text] if element.tag == "style" else []
    for child in element.children:
        texts += _texts(child)
    return texts


def _rules(text: str) -> list[Rule]:
    rules = []
    # Split rather than matched by one expression: that would take the square of a long text.
    for block in COMMENT.sub(" ", text).split("}"):
        selectors, brace, body = block.rpartition("{")
        if not brace:
            continue
        properties = declarations(body)
        for selector in selectors.rpartition("{")[2].split(","):
            found = COMPOUND.match(selector.strip())
            if found is None or not selector.strip():
                continue
            tag, marks = found.group(1) or "", re.findall(r"([.#])([\w-]+)", found.group(2))
            identity = next((name for sign, name in marks if sign == "#"), "")
            classes = frozenset(name for sign, name in marks if sign == ".")
            rules.append(Rule("" if tag == "*" else tag, identity, classes, properties))
    return rules


def color_of(text: str, current: str = CURRENT) -> tuple[str | None, float]:
    """ "#rrggbb" and opacity of a color, None where nothing is painted.

    "currentColor" stays so where the drawing does not say what it is. What is no color at all
    counts as black, as it does where a drawing says nothing.
    """
    if text.lower() == CURRENT.lower():
        text = current
    if text.lower() == CURRENT.lower():
        return CURRENT, 1.0
    if text.lower() in ("none", "transparent"):
        return None, 1.0
    if len(text) > LONGEST_COLOR:
        return BLACK, 1.0
    color = Color(text)
    if color.value is None:
        return BLACK, 1.0
    return f"#{color.red:02x}{color.green:02x}{color.blue:02x}", float(color.opacity)


def reference(text: str) -> str:
    """The id in "url(#id)", "" where there is none."""
    found = re.match(r"url\(\s*[\"']?#([^\"')]*)", text)
    return found.group(1).strip() if found else ""


def share(text: str, default: float = 1.0) -> float:
    """An opacity: a number or a percentage, between 0 and 1."""
    try:
        value = float(text[:-1]) / 100.0 if text.endswith("%") else float(text)
    except ValueError:
        return default
    return min(max(value, 0.0), 1.0) if value == value else default
