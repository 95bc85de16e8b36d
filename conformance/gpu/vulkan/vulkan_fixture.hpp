// For tests that need a device of Vulkan: the last one of this machine, which runs on the CPU where there is one that
// does. Without any they are skipped; the test conform.all fails there.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>

#include "gpu/vulkan/device.hpp"
#include "gpu/vulkan_drivers.hpp"

namespace hn {

template <typename Base = testing::Test>
class OnVulkan : public Base {
 protected:
  void SetUp() override {
    for (const auto& [name, value] : vulkan_environment()) setenv(name.c_str(), value.c_str(), 1);
    const int count = vulkan_device_count();
    if (count == 0) GTEST_SKIP() << "no device of Vulkan is here";
    number_ = count - 1;
  }

  int number_ = 0;
};

}  // namespace hn
