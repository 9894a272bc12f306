"""What tools and views share: pointers, picking, snapping, gestures. No Qt."""
