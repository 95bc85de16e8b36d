#include "output/page.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace hn {
namespace {

using Json = nlohmann::json;

std::string page(std::string_view text, const Json& data) {
  const auto result = render_page(text, data);
  return result ? *result : "error: " + result.error().text();
}

TEST(Page, NumbersAreText) {
  EXPECT_EQ(page("{{a}} {{b}} {{c}} {{d}}", {{"a", 3}, {"b", -0.25}, {"c", 18446744073709551615u}, {"d", "1.50"}}),
            "3 -0.25 18446744073709551615 1.50");
}

TEST(Page, ListsOfTextObjectsAndFlags) {
  const Json data = {{"list", {"a", "b"}}, {"machine", {{"name", "m"}}}, {"yes", true}, {"no", false},
                     {"none", nullptr},    {"empty", Json::array()}};
  EXPECT_EQ(page("{{#list}}{{.}};{{/list}}", data), "a;b;");
  EXPECT_EQ(page("{{machine.name}}{{#machine}}{{name}}{{/machine}}", data), "mm");
  EXPECT_EQ(page("{{#yes}}1{{/yes}}{{#no}}2{{/no}}{{#none}}3{{/none}}{{#empty}}4{{/empty}}", data), "1");
  EXPECT_EQ(page("{{^yes}}1{{/yes}}{{^no}}2{{/no}}{{^none}}3{{/none}}{{^empty}}4{{/empty}}", data), "234");
}

TEST(Page, TagsWithoutDataAreNamed) {
  EXPECT_EQ(page("{{a}} {{absent}} {{{gone}}} {{absent}}", {{"a", 1}}),
            "error: the template has tags without data: {{absent}}, {{gone}}");
  EXPECT_EQ(page("{{#rows}}{{/rows}}", Json::object()), "error: the template has tags without data: {{rows}}");
  EXPECT_EQ(page("{{^rows}}{{/rows}}", Json::object()), "error: the template has tags without data: {{rows}}");
  EXPECT_EQ(page("{{a.b}}", {{"a", {{"c", 1}}}}), "error: the template has tags without data: {{a.b}}");
  EXPECT_EQ(page("{{> part}}", Json::object()), "error: the template has tags without data: {{> part}}");
  EXPECT_EQ(page("{{> part}}", {{"part", true}}), "error: the template has tags without data: {{> part}}");
}

TEST(Page, TagsWithoutDataInSectionsAndPartialsAreNamed) {
  EXPECT_EQ(page("{{#rows}}{{x}}{{/rows}}", {{"rows", {{{"x", 1}}, {{"y", 2}}}}}),
            "error: the template has tags without data: {{x}}");
  EXPECT_EQ(page("{{> part}}", {{"part", "{{x}}"}}), "error: the template has tags without data: {{x}}");
}

TEST(Page, BrokenTemplatesAreErrors) {
  EXPECT_EQ(page("{{#a}}x", {{"a", true}}), "error: the template is not Mustache: Unclosed section \"a\" at 0");
  EXPECT_EQ(page("x {{a", {{"a", 1}}), "error: the template is not Mustache: Unclosed tag at 2");
  EXPECT_EQ(page("{{> part}}", {{"part", "{{#a}}"}, {"a", true}}),
            "error: the template is not Mustache: Unclosed section \"a\" at 0");
}

}  // namespace
}  // namespace hn
