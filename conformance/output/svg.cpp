#include "output/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace hn {
namespace {

// All lengths are in pixels.
constexpr double kWidth = 720.0;
constexpr double kHeight = 380.0;
constexpr double kTop = 40.0;        // the title's place
constexpr double kBottom = 52.0;     // the x axis' place: figures and label
constexpr double kLeft = 76.0;       // the y axis' place
constexpr double kRight = 20.0;      // so that the last figure of the x axis is not cut
constexpr double kCharacter = 7.5;   // the mean width of a character of 13 pixels, rather too wide than too narrow
constexpr double kRow = 28.0;        // from bar to bar
constexpr double kFigures = 76.0;    // the place of a bar's value
constexpr double kLegendRow = 22.0;  // from name to name

// Okabe and Ito's colours, without black and yellow, which are lost on a dark or on a light page.
constexpr std::array kColours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00"};
// Around the origin. Four shapes and six colours: twelve series differ.
constexpr std::array kMarkers = {"M-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0z", "M-3.5-3.5h7v7h-7z", "M0-4.5L4.5 3.5H-4.5z",
                                 "M0-5L5 0L0 5L-5 0z"};

// Not NaN, not infinite, and not so large that the arithmetic of the axes would overflow.
bool drawable(double value) { return std::abs(value) < 1e100; }

// A coordinate: two decimals at most.
std::string px(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;  // XML has no control characters
    }
  }
  return out;
}

// An estimate: characters of UTF-8 are the bytes that continue none.
double width_of(std::string_view text) {
  return kCharacter * static_cast<double>(std::count_if(text.begin(), text.end(), [](char c) {
           return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
         }));
}

std::string text_at(double x, double y, std::string_view anchor, std::string_view text, std::string_view more = {}) {
  if (text.empty()) return {};
  return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\"{}>{}</text>\n", px(x), px(y), anchor, more,
                     escaped(text));
}

std::string line(double x1, double y1, double x2, double y2, std::string_view more = {}) {
  return fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"currentColor\"{}/>\n", px(x1), px(y1),
                     px(x2), px(y2), more);
}

std::string document(const PlotText& text, double width, double height, std::string_view body) {
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{}\" width=\"{}\" height=\"{}\" "
             "viewBox=\"0 0 {} {}\" font-family=\"system-ui, sans-serif\" font-size=\"13\" fill=\"currentColor\">\n",
             escaped(text.title), px(width), px(height), px(width), px(height)) +
         text_at(width / 2, 22, "middle", text.title, " font-size=\"15\" font-weight=\"600\"") + std::string(body) +
         "</svg>\n";
}

std::string no_data(const PlotText& text) {
  constexpr double kLow = 120.0;
  return document(text, kWidth, kLow, text_at(kWidth / 2, 76, "middle", "no data", " opacity=\"0.7\""));
}

struct Extent {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;

  void add(double value) {
    if (!drawable(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool empty() const { return low > high; }
};

// Values [low, high] on pixels [from, to], with a tick at each multiple of step.
struct Axis {
  double low, high, from, to, step;

  Axis(Extent extent, double first_pixel, double last_pixel, double ticks)
      : low(extent.low), high(extent.high), from(first_pixel), to(last_pixel) {
    // An extent of next to nothing is widened, or ticks could not be told apart in double.
    const double size = std::max({std::abs(low), std::abs(high), 1e-90});
    if (high - low < 1e-9 * size) {
      low -= 0.5 * size;
      high += 0.5 * size;
    }
    const double wanted = (high - low) / ticks;
    const double power = std::pow(10.0, std::floor(std::log10(wanted)));
    step = power * (wanted <= power ? 1.0 : wanted <= 2.0 * power ? 2.0 : wanted <= 5.0 * power ? 5.0 : 10.0);
  }
  // Both ends moved outwards to a tick. A billionth of a step is rounding, not distance.
  void round() {
    low = std::floor(low / step + 1e-9) * step;
    high = std::ceil(high / step - 1e-9) * step;
  }
  double at(double value) const { return from + (value - low) / (high - low) * (to - from); }
  std::vector<double> ticks() const {
    std::vector<double> values;
    for (double i = std::ceil(low / step - 1e-9); i <= high / step + 1e-9; i += 1.0) {
      values.push_back(i * step + 0.0);  // -0 + 0 is 0
    }
    return values;
  }
};

constexpr std::string_view kGrid = " opacity=\"0.15\"";

std::string x_axis(const Axis& x, double y, std::string_view label) {
  std::string body = line(x.from, y, x.to, y);
  for (const double tick : x.ticks()) {
    body += line(x.at(tick), y, x.at(tick), y + 5);
    body += text_at(x.at(tick), y + 19, "middle", fmt::format("{:.10g}", tick), " font-size=\"12\"");
  }
  return body + text_at((x.from + x.to) / 2, y + 41, "middle", label);
}

std::string y_axis(const Axis& y, double left, double right, std::string_view label) {
  std::string body = line(left, y.from, left, y.to);
  for (const double tick : y.ticks()) {
    body += line(left, y.at(tick), right, y.at(tick), kGrid);
    body += text_at(left - 8, y.at(tick) + 4, "end", fmt::format("{:.10g}", tick), " font-size=\"12\"");
  }
  const double middle = (y.from + y.to) / 2;
  return body + text_at(16, middle, "middle", label, fmt::format(" transform=\"rotate(-90 16 {})\"", px(middle)));
}

Axis y_axis_of(Extent extent) {
  extent.add(0.0);
  if (extent.high == extent.low) extent.high = 1.0;
  Axis y(extent, kHeight - kBottom, kTop, 6.0);
  y.round();
  return y;
}

std::string marker(std::size_t index, double x, double y) {
  return fmt::format("<path d=\"{}\" transform=\"translate({} {})\" fill=\"{}\"/>\n", kMarkers[index % kMarkers.size()],
                     px(x), px(y), kColours[index % kColours.size()]);
}

// The points that can be drawn, joined; where one is left out, the line is broken.
std::string curve_path(const std::vector<double>& xs, const std::vector<double>& ys, const Axis& x, const Axis& y) {
  std::string path;
  bool down = false;
  for (std::size_t i = 0; i < std::min(xs.size(), ys.size()); ++i) {
    const bool draw = drawable(xs[i]) && drawable(ys[i]);
    if (draw) path += fmt::format("{}{} {}", down ? "L" : "M", px(x.at(xs[i])), px(y.at(ys[i])));
    down = draw;
  }
  return path;
}

std::string stroke(std::string_view path, std::size_t index, std::string_view more = {}) {
  return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{}/>\n", path,
                     kColours[index % kColours.size()], more);
}

// Three significant digits and no exponent where that is readable.
std::string figures(double value) {
  const double size = std::abs(value);
  if (size == 0.0) return "0";
  if (size < 1e-4 || size >= 1e6) return fmt::format("{:.2e}", value);
  return fmt::format("{:.{}f}", value, std::max(0, 2 - static_cast<int>(std::floor(std::log10(size)))));
}

std::string bar_row(const Bar& bar, std::size_t index, const Axis& x) {
  const double middle = kTop + kRow * (static_cast<double>(index) + 0.5);
  std::string body = text_at(x.from - 10, middle + 4, "end", bar.name);
  if (!drawable(bar.value)) return body + text_at(x.from + 8, middle + 4, "start", "no value", " opacity=\"0.7\"");
  const double begin = x.at(std::min(bar.value, 0.0));
  const double end = x.at(std::max(bar.value, 0.0));
  body += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"18\" fill=\"{}\"/>\n", px(begin), px(middle - 9),
                      px(end - begin), kColours[bar.marked ? 1 : 0]);
  if (drawable(bar.spread) && bar.spread > 0.0) {
    const double low = x.at(bar.value - bar.spread);
    const double high = x.at(bar.value + bar.spread);
    body += line(low, middle, high, middle, " stroke-width=\"1.5\"");
    for (const double tip : {low, high}) body += line(tip, middle - 5, tip, middle + 5, " stroke-width=\"1.5\"");
  }
  // The figures stand in a column, clear of the guide line.
  return body + text_at(x.to + kFigures - 8, middle + 4, "end", figures(bar.value), " font-size=\"12\"");
}

}  // namespace

std::string line_plot(const PlotText& text, std::span<const Series> series) {
  Extent x_extent;
  Extent y_extent;
  double legend = 0.0;
  bool whole = true;
  for (const Series& one : series) {
    legend = std::max(legend, width_of(one.name));
    for (std::size_t i = 0; i < std::min(one.x.size(), one.y.size()); ++i) {
      if (!drawable(one.x[i]) || !drawable(one.y[i])) continue;
      whole = whole && one.x[i] == std::floor(one.x[i]);
      x_extent.add(one.x[i]);
      y_extent.add(one.y[i]);
    }
  }
  if (x_extent.empty()) return no_data(text);
  const double right = kWidth - kRight;
  Axis x(x_extent, kLeft, right, 8.0);
  if (whole) x.step = std::max(x.step, 1.0);  // there are no half octaves
  const Axis y = y_axis_of(y_extent);
  std::string body = y_axis(y, kLeft, right, text.y_label) + x_axis(x, y.from, text.x_label);
  for (std::size_t s = 0; s < series.size(); ++s) {
    const Series& one = series[s];
    body += stroke(curve_path(one.x, one.y, x, y), s);
    for (std::size_t i = 0; i < std::min(one.x.size(), one.y.size()); ++i) {
      if (drawable(one.x[i]) && drawable(one.y[i])) body += marker(s, x.at(one.x[i]), y.at(one.y[i]));
    }
    const double row = kTop + kLegendRow * (static_cast<double>(s) + 0.5);
    body += stroke(fmt::format("M{} {}h26", px(right + 14), px(row)), s) + marker(s, right + 27, row);
    body += text_at(right + 48, row + 4, "start", one.name);
  }
  const double legend_height = kTop + kLegendRow * static_cast<double>(series.size()) + 8;
  return document(text, right + 48 + legend + 8, std::max(kHeight, legend_height), body);
}

std::string histogram_plot(const PlotText& text, double low, double high, std::span<const double> density,
                           const std::function<double(double)>& curve) {
  Extent extent;
  for (const double value : density) extent.add(value);
  if (extent.empty() || !drawable(low) || !drawable(high) || !(low < high)) return no_data(text);
  std::vector<double> xs;
  std::vector<double> ys;
  constexpr int kCurvePieces = 300;  // about two pixels each
  for (int i = 0; curve && i <= kCurvePieces; ++i) {
    xs.push_back(low + (high - low) * i / kCurvePieces);
    ys.push_back(curve(xs.back()));
    extent.add(ys.back());
  }
  const Axis x({low, high}, kLeft, kWidth - kRight, 8.0);
  const Axis y = y_axis_of(extent);
  const std::string floor = px(y.at(0.0));
  const auto edge = [&](std::size_t bin) {
    return px(x.from + (x.to - x.from) * static_cast<double>(bin) / static_cast<double>(density.size()));
  };
  std::string steps = fmt::format("M{} {}", edge(0), floor);
  for (std::size_t bin = 0; bin < density.size(); ++bin) {
    steps += fmt::format("V{}H{}", drawable(density[bin]) ? px(y.at(density[bin])) : floor, edge(bin + 1));
  }
  std::string body = y_axis(y, x.from, x.to, text.y_label);
  body += fmt::format("<path d=\"{}V{}z\" fill=\"{}\" fill-opacity=\"0.7\"/>\n", steps, floor, kColours[0]);
  body += x_axis(x, y.from, text.x_label);
  if (curve) body += stroke(curve_path(xs, ys, x, y), 1);
  return document(text, kWidth, kHeight, body);
}

std::string bar_plot(const PlotText& text, std::span<const Bar> bars) {
  Extent extent{0.0, 1.0};  // bars begin at 0, and the guide line is at 1
  double names = width_of(text.y_label);
  bool any = false;
  for (const Bar& bar : bars) {
    names = std::max(names, width_of(bar.name));
    any = any || drawable(bar.value);
    extent.add(bar.value);
    if (!drawable(bar.spread) || bar.spread < 0.0) continue;
    extent.add(bar.value - bar.spread);
    extent.add(bar.value + bar.spread);
  }
  if (!any) return no_data(text);
  const double left = names + 24;
  const double right = std::max(left + 240.0, kWidth - kFigures);
  const double floor = kTop + kRow * static_cast<double>(bars.size()) + 4;
  const Axis x(extent, left, right, 8.0);
  std::string body;
  for (const double tick : x.ticks()) body += line(x.at(tick), kTop, x.at(tick), floor, kGrid);
  for (std::size_t i = 0; i < bars.size(); ++i) body += bar_row(bars[i], i, x);
  body += line(x.at(0.0), kTop, x.at(0.0), floor);
  body += line(x.at(1.0), kTop - 4, x.at(1.0), floor, " stroke-width=\"1.5\" stroke-dasharray=\"5 4\"");
  body += x_axis(x, floor, text.x_label) + text_at(left - 10, floor + 19, "end", text.y_label);
  return document(text, right + kFigures, floor + kBottom, body);
}

}  // namespace hn
