// Land that a shader draws. The arrow keys move it, and the title shows how high it is under the pointer: C++ computes
// that from the same text, with the same bits.
#define HN_ARITHMETIC HN_FIXED
#include <cstdio>
#include <exception>
#include <hashnoise/hashnoise.hpp>

#include "noise.frag.h"
#include "noise.vert.h"
#include "window.hpp"

namespace hashnoise {
#include "height.glsl"
}

static void run() {
  Window<hashnoise::ivec2> window(640, 480, noise_vert, noise_frag);
  hashnoise::ivec2 corner(0, 0);  // the place in the upper left
  while (!glfwWindowShouldClose(window.glfw())) {
    window.draw(corner);

    glfwPollEvents();
    const auto step = [&](int key) { return glfwGetKey(window.glfw(), key) == GLFW_PRESS ? 4 : 0; };
    corner.x += step(GLFW_KEY_RIGHT) - step(GLFW_KEY_LEFT);
    corner.y += step(GLFW_KEY_DOWN) - step(GLFW_KEY_UP);

    double x = 0.0, y = 0.0;
    glfwGetCursorPos(window.glfw(), &x, &y);
    const hashnoise::ivec2 place(corner.x + static_cast<int>(x), corner.y + static_cast<int>(y));
    char title[80];
    std::snprintf(title, sizeof title, "%d, %d: %.6f high", place.x, place.y, hashnoise::height(place));
    glfwSetWindowTitle(window.glfw(), title);
  }
}

int main() {
  try {
    run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
