// Plots as SVG, to stand inside a page: nothing is loaded from elsewhere, and axes and text have the colour of the text
// around them, so that they are readable on a light and on a dark page. A value that is not finite is left out.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace hn {

struct PlotText {
  std::string title;
  std::string x_label;
  std::string y_label;
};

struct Series {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;  // as many as x; what one has more than the other is not drawn
};

// Lines with markers and a legend. The y axis begins at 0, or below for negative values.
std::string line_plot(const PlotText& text, std::span<const Series> series);

// The density of a histogram whose bins divide [low, high] evenly, with the curve to compare it with, if there is one.
std::string histogram_plot(const PlotText& text, double low, double high, std::span<const double> density,
                           const std::function<double(double)>& curve = {});

struct Bar {
  std::string name;
  double value = 0.0;
  double spread = 0.0;  // the whisker reaches from value - spread to value + spread; 0 for none
  bool marked = false;  // in another colour, since it is the one to look at
};

// Horizontal bars, a row each, with a guide line at 1. A bar without a finite value keeps its row and says so.
std::string bar_plot(const PlotText& text, std::span<const Bar> bars);

}  // namespace hn
