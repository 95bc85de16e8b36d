#include "output/svg.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>

namespace hn {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool has(const std::string& svg, std::string_view part) { return svg.find(part) != std::string::npos; }

std::ptrdiff_t count(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  return std::distance(std::sregex_iterator(text.begin(), text.end(), regex), std::sregex_iterator());
}

// What holds for every plot: numbers are finite and short, nothing is loaded, and elements are closed.
void expect_sound(const std::string& svg) {
  EXPECT_EQ(svg.rfind("<svg xmlns=\"http://www.w3.org/2000/svg\" ", 0), 0u);
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_EQ(count(svg, "nan|inf|\"-0\"|>-0<|href|url\\(|<style|<script"), 0) << svg;
  EXPECT_EQ(count(svg, "\\.\\d{3,}[^\\d<]"), 0) << svg;  // what ends at < is text
  EXPECT_EQ(count(svg, "<[a-z]"), count(svg, "/>|</[a-z]"));
}

TEST(Svg, LinesAreWhereTheirValuesAre) {
  // x from 0 to 2 is 76 to 700, y from 0 to 4 is 328 to 40.
  const std::string svg = line_plot({"Title", "across", "up"}, std::vector<Series>{{"one", {0, 1, 2}, {0, 4, 1}}});
  expect_sound(svg);
  EXPECT_TRUE(has(svg, "<path d=\"M76 328L388 40L700 256\" fill=\"none\" stroke=\"#0072B2\" stroke-width=\"2\"/>"));
  EXPECT_TRUE(has(svg, "transform=\"translate(388 40)\""));
  for (const char* text : {">Title</text>", ">across</text>", ">up</text>", ">one</text>", ">0</text>", ">4</text>"}) {
    EXPECT_TRUE(has(svg, text)) << text;
  }
}

TEST(Svg, TheYAxisBeginsAtZeroAndEndsAtATick) {
  const std::string svg = line_plot({}, std::vector<Series>{{"", {1, 2}, {7.3, 9.1}}});
  for (const char* tick : {">0<", ">2<", ">4<", ">6<", ">8<", ">10<"}) EXPECT_TRUE(has(svg, tick)) << tick;
  EXPECT_FALSE(has(svg, ">12<"));
  EXPECT_TRUE(has(line_plot({}, std::vector<Series>{{"", {1, 2}, {-3.0, 1.0}}}), ">-3<"));
}

TEST(Svg, WholeNumbersHaveNoTicksBetween) {
  EXPECT_FALSE(has(line_plot({}, std::vector<Series>{{"", {1, 3}, {1, 10}}}), ">1.5<"));
  EXPECT_TRUE(has(line_plot({}, std::vector<Series>{{"", {1, 2.5, 3}, {1, 1, 10}}}), ">1.5<"));
}

TEST(Svg, SeriesDifferInColourAndMarker) {
  std::vector<Series> series(7, Series{"s", {0, 1}, {0, 1}});
  const std::string svg = line_plot({}, series);
  expect_sound(svg);
  for (const char* colour : {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00"}) {
    EXPECT_TRUE(has(svg, colour)) << colour;
  }
  EXPECT_EQ(count(svg, "a4 4 0 1 0 8 0"), 2 * 3);  // discs: the first and the fifth, two points and the legend
}

TEST(Svg, ValuesThatAreNotFiniteAreLeftOutOfLines) {
  const std::vector<double> x = {0, 1, 2, 3, kNan, 4};
  const std::vector<double> y = {0, 4, kInfinity, 4, 4, 1e300};
  const std::string svg = line_plot({}, std::vector<Series>{{"one", x, y}});
  expect_sound(svg);
  EXPECT_TRUE(has(svg, "d=\"M76 328L284 40M700 40\""));
  EXPECT_EQ(count(svg, "translate"), 3 + 1);
}

TEST(Svg, WhatOneCoordinateHasMoreThanTheOtherIsNotDrawn) {
  EXPECT_TRUE(has(line_plot({}, std::vector<Series>{{"", {0, 2, 9}, {4, 4}}}), "d=\"M76 40L700 40\""));
}

TEST(Svg, ExtentsOfNothingAndOfAlmostNothingAreDrawn) {
  for (const double value : {0.0, 5.0, -1e-300, 1e99, -1e99}) {
    expect_sound(line_plot({}, std::vector<Series>{{"", {value, value}, {value, value}}}));
  }
  expect_sound(line_plot({}, std::vector<Series>{{"", {1e15, 1e15 + 0.125}, {-1e99, 1e99}}}));
}

TEST(Svg, TextIsEscaped) {
  const std::string svg = line_plot({"a<b>\"&\n", "", ""}, std::vector<Series>{{"<i>", {0}, {1}}});
  expect_sound(svg);
  EXPECT_TRUE(has(svg, "aria-label=\"a&lt;b&gt;&quot;&amp; \""));
  EXPECT_TRUE(has(svg, ">a&lt;b&gt;&quot;&amp; </text>"));
  EXPECT_TRUE(has(svg, ">&lt;i&gt;</text>"));
}

TEST(Svg, HistogramsAreSteps) {
  // x from -1 to 1 is 76 to 700, y from 0 to 0.6 is 328 to 40.
  const std::string svg = histogram_plot({"h", "", ""}, -1.0, 1.0, std::vector<double>{0.3, kNan, 0.6});
  expect_sound(svg);
  EXPECT_TRUE(has(svg, "d=\"M76 328V184H284V328H492V40H700V328z\""));
  EXPECT_EQ(count(svg, "stroke=\"#D55E00\""), 0);
}

TEST(Svg, HistogramsHaveTheirCurve) {
  const auto pole = [](double x) { return x < -0.5 ? kNan : 1.0; };
  const std::string svg = histogram_plot({}, -1.0, 1.0, std::vector<double>{0.5, 0.5}, pole);
  expect_sound(svg);
  EXPECT_TRUE(has(svg, "<path d=\"M232 40L234.08 40L"));
  EXPECT_EQ(count(svg, "stroke=\"#D55E00\""), 1);
}

TEST(Svg, BarsHaveWhiskersFiguresAndTheGuide) {
  // x from 0 to 2.5 is 54 to 644: names of 4 characters are taken as 30 wide.
  const std::vector<Bar> bars = {{"slow", 2.0, 0.5}, {"fast", 0.0432, 0.0}, {"none", kNan, 0.1}, {"σσσσ", 1.0, kNan}};
  const std::string svg = bar_plot({"b", "", ""}, bars);
  expect_sound(svg);
  EXPECT_TRUE(has(svg, "<rect x=\"54\" y=\"45\" width=\"472\" height=\"18\""));
  EXPECT_TRUE(has(svg, "<line x1=\"408\" y1=\"54\" x2=\"644\" y2=\"54\""));
  EXPECT_TRUE(has(svg, "<line x1=\"290\" y1=\"36\" x2=\"290\" y2=\"156\""));  // the guide
  for (const char* text : {">2.00<", ">0.0432<", ">no value<", ">1.00<", ">none<"}) EXPECT_TRUE(has(svg, text)) << text;
  EXPECT_EQ(count(svg, "<rect"), 3);
}

TEST(Svg, AMarkedBarHasAnotherColour) {
  const std::string svg = bar_plot({}, std::vector<Bar>{{"a", 1.0, 0.0}, {"b", 2.0, 0.0, true}, {"c", 3.0, 0.0}});
  expect_sound(svg);
  EXPECT_EQ(count(svg, "fill=\"#0072B2\""), 2);
  EXPECT_EQ(count(svg, "fill=\"#D55E00\""), 1);
}

TEST(Svg, BarsBelowOneStillHaveTheGuide) {
  const std::string svg = bar_plot({}, std::vector<Bar>{{"a", 0.25, 0.0}, {"b", -0.5, 0.0}});
  expect_sound(svg);
  EXPECT_EQ(count(svg, "stroke-dasharray"), 1);
}

TEST(Svg, FiguresOfBarsAreReadable) {
  const std::vector<Bar> bars = {{"", 123456.7, 0}, {"", 0.000123, 0}, {"", 1e7, 0}, {"", 0, 0}, {"", -9.994, 0}};
  const std::string svg = bar_plot({}, bars);
  for (const char* text : {">123457<", ">0.000123<", ">1.00e+07<", ">0<", ">-9.99<"}) {
    EXPECT_TRUE(has(svg, text)) << text;
  }
}

TEST(Svg, PlotsWithoutDataSaySo) {
  const std::vector<double> nothing = {kNan, kInfinity};
  const std::vector<double> half = {0.5};
  for (const std::string& svg :
       {line_plot({"t", "", ""}, {}), line_plot({"t", "", ""}, std::vector<Series>{{"a", {1}, {kNan}}}),
        histogram_plot({"t", "", ""}, 0, 1, {}), histogram_plot({"t", "", ""}, 0, 1, nothing),
        histogram_plot({"t", "", ""}, 1, 1, half), histogram_plot({"t", "", ""}, kNan, 1, half),
        bar_plot({"t", "", ""}, {}), bar_plot({"t", "", ""}, std::vector<Bar>{{"a", kNan, 1}})}) {
    expect_sound(svg);
    EXPECT_TRUE(has(svg, ">no data</text>"));
    EXPECT_TRUE(has(svg, ">t</text>"));
  }
}

}  // namespace
}  // namespace hn
