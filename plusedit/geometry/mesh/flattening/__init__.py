"""What the maps of meshes share: the sheet of triangles, weights, paths, equations, distortion."""
