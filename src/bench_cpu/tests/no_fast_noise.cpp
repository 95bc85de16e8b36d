// A shared library that is not FastNoise2.
extern "C" int fnGetMetadataCount() { return 0; }
