// How high the land is, in [-1, 1]: shaders and C++ include this text, and HN_FIXED gives both the same bits. 128
// pixels make a cell; the whole numbers keep it exact, however far you go.
float height(ivec2 pixel) { return hn_fbm(hn_place(pixel, 1, 128), 6, 2.0f, 0.5f, 7u); }
