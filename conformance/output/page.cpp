#include "output/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>
#include <vector>

namespace hn {
namespace {

using Data = kainjow::mustache::data;

Data to_mustache(const nlohmann::json& json) {
  if (json.is_object()) {
    Data object(Data::type::object);
    for (const auto& [name, value] : json.items()) object[name] = to_mustache(value);
    return object;
  }
  if (json.is_array()) {
    kainjow::mustache::list list;
    list.reserve(json.size());
    for (const nlohmann::json& value : json) list.push_back(to_mustache(value));
    return Data(list);
  }
  if (json.is_string()) return Data(json.get_ref<const std::string&>());
  if (json.is_number()) return Data(json.dump());
  return Data(json.is_boolean() && json.get<bool>());
}

// kainjow writes nothing for a tag without data; this remembers those tags.
class StrictContext : public kainjow::mustache::context<std::string> {
 public:
  using Base = kainjow::mustache::context<std::string>;
  using Base::Base;

  const Data* get(const std::string& name) const override { return noted(Base::get(name), name); }

  const Data* get_partial(const std::string& name) const override {
    const Data* data = Base::get_partial(name);
    return noted(data != nullptr && data->is_string() ? data : nullptr, "> " + name);
  }

  const std::vector<std::string>& missing() const { return missing_; }

 private:
  const Data* noted(const Data* data, const std::string& tag) const {
    if (data == nullptr && std::find(missing_.begin(), missing_.end(), tag) == missing_.end()) missing_.push_back(tag);
    return data;
  }

  mutable std::vector<std::string> missing_;  // get is const for kainjow
};

}  // namespace

Result<std::string> render_page(std::string_view mustache_template, const nlohmann::json& data) {
  kainjow::mustache::mustache page{std::string(mustache_template)};
  if (!page.is_valid()) return fail("the template is not Mustache: " + page.error_message());
  const Data values = to_mustache(data);
  StrictContext context(&values);
  std::string text = page.render(context);
  if (!page.is_valid()) return fail("the template is not Mustache: " + page.error_message());
  if (context.missing().empty()) return text;
  std::string tags;
  for (const std::string& tag : context.missing()) tags += fmt::format("{}{{{{{}}}}}", tags.empty() ? "" : ", ", tag);
  return fail("the template has tags without data: " + tags);
}

}  // namespace hn
