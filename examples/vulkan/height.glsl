// How high the land is, in [-1, 1]: shaders and C++ include this text, and HN_FIXED gives both the same bits. A pixel
// is a place, and 128 of them make a cell; the whole numbers keep it exact, however far you go.
float height(ivec2 place) {
  return hn_fbm(hn_cell(place, 1, 128), hn_fraction(place, 1, 128), 6, 2.0f, 0.5f, 7u);
}
