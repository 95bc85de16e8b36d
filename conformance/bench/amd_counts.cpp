// The process that counts for AMD, for the tests: hn-conform is above this room.
#include "bench/amd.hpp"

int main(int argc, char** argv) { return argc == 3 ? hn::amd_counts_child(argv[2]) : EXIT_FAILURE; }
