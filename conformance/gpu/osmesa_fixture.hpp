// For tests that need a context: OSMesa's, which every machine of ours has.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "gpu/driver/driver.hpp"

namespace hn {

template <typename Base = testing::Test>
class OnOsmesa : public Base {
 protected:
  void SetUp() override {
    auto context = create_osmesa();
    ASSERT_TRUE(context) << context.error().text();
    context_ = std::move(*context);
  }

  std::unique_ptr<Context> context_;
};

}  // namespace hn
