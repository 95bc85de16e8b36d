#include "bench/shader_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <nlohmann/json.hpp>
#include <optional>
#include <spirv-tools/libspirv.hpp>
#include <stdexcept>
#include <string_view>
#include <vector>

#define VK_NO_PROTOTYPES
#include <vulkan/vulkan_raii.hpp>

#include "base/file.hpp"
#include "base/json.hpp"

namespace hn {
namespace {

constexpr std::uint32_t kSamplers = 4;
constexpr std::uint32_t kPushConstantBytes = 16;
constexpr const char* kStatisticsExtension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;

// Passes a vertex attribute on. A value that the driver could know (a constant, equal components) would be folded into
// the fragment shader and change its count.
constexpr const char* kVertexShader = R"(
               OpCapability Shader
               OpMemoryModel Logical GLSL450
               OpEntryPoint Vertex %main "main" %attribute %position %point
               OpDecorate %attribute Location 0
               OpDecorate %position BuiltIn Position
               OpDecorate %point Location 0
       %void = OpTypeVoid
   %function = OpTypeFunction %void
      %float = OpTypeFloat 32
       %vec4 = OpTypeVector %float 4
      %input = OpTypePointer Input %vec4
     %output = OpTypePointer Output %vec4
  %attribute = OpVariable %input Input
   %position = OpVariable %output Output
      %point = OpVariable %output Output
       %main = OpFunction %void None %function
      %label = OpLabel
      %value = OpLoad %vec4 %attribute
               OpStore %position %value
               OpStore %point %value
               OpReturn
               OpFunctionEnd
)";

using Words = std::vector<std::uint32_t>;

Words vertex_shader() {
  Words words;
  if (!spvtools::SpirvTools(SPV_ENV_VULKAN_1_0).Assemble(kVertexShader, &words)) {
    throw std::runtime_error("the vertex shader cannot be assembled");
  }
  return words;
}

double processor_seconds() {
  // The clock counts all threads, since a driver may compile in others.
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

double number_of(const vk::PipelineExecutableStatisticKHR& statistic) {
  switch (statistic.format) {
    case vk::PipelineExecutableStatisticFormatKHR::eBool32:
      return statistic.value.b32;
    case vk::PipelineExecutableStatisticFormatKHR::eInt64:
      return static_cast<double>(statistic.value.i64);
    case vk::PipelineExecutableStatisticFormatKHR::eFloat64:
      return statistic.value.f64;
    default:
      return static_cast<double>(statistic.value.u64);
  }
}

vk::raii::PhysicalDevice first_gpu(const vk::raii::Instance& instance) {
  vk::raii::PhysicalDevices gpus(instance);
  if (gpus.empty()) throw std::runtime_error("the driver offers no GPU");
  const auto extensions = gpus.front().enumerateDeviceExtensionProperties();
  if (std::ranges::none_of(extensions, [](const vk::ExtensionProperties& extension) {
        return std::string_view(extension.extensionName) == kStatisticsExtension;
      })) {
    throw std::runtime_error(
        fmt::format("{} has no {}", gpus.front().getProperties().deviceName.data(), kStatisticsExtension));
  }
  return std::move(gpus.front());
}

class Compiler {
 public:
  nlohmann::json description() const {
    // This is of Vulkan 1.2, which the loader of Debian 12 hands through; older drivers leave it as it is.
    const auto found = gpu_.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
    return {{"device", found.get<vk::PhysicalDeviceProperties2>().properties.deviceName.data()},
            {"driver", found.get<vk::PhysicalDeviceDriverProperties>().driverInfo.data()}};
  }

  nlohmann::json compile(const Words& fragment_shader) const {
    const vk::raii::ShaderModule fragment(device_, vk::ShaderModuleCreateInfo({}, fragment_shader));
    const std::array stages = {
        vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eVertex, *vertex_, "main"),
        vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eFragment, *fragment, "main")};
    const vk::VertexInputBindingDescription binding(0, 4 * sizeof(float));
    const vk::VertexInputAttributeDescription attribute(0, 0, vk::Format::eR32G32B32A32Sfloat);
    const vk::PipelineVertexInputStateCreateInfo input({}, binding, attribute);
    const vk::PipelineInputAssemblyStateCreateInfo assembly({}, vk::PrimitiveTopology::eTriangleList);
    const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
    const auto raster = vk::PipelineRasterizationStateCreateInfo().setLineWidth(1.0f);
    const vk::PipelineMultisampleStateCreateInfo samples;
    using Component = vk::ColorComponentFlagBits;
    const auto target = vk::PipelineColorBlendAttachmentState().setColorWriteMask(Component::eR | Component::eG |
                                                                                  Component::eB | Component::eA);
    const auto blend = vk::PipelineColorBlendStateCreateInfo().setAttachments(target);
    const std::array states = {vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic({}, states);
    const vk::GraphicsPipelineCreateInfo info(vk::PipelineCreateFlagBits::eCaptureStatisticsKHR, stages, &input,
                                              &assembly, nullptr, &viewport, &raster, &samples, nullptr, &blend,
                                              &dynamic, *layout_, *pass_);
    const double before = processor_seconds();
    const vk::raii::Pipeline pipeline(device_, nullptr, info);
    const double seconds = processor_seconds() - before;
    const auto executables = device_.getPipelineExecutablePropertiesKHR(vk::PipelineInfoKHR(*pipeline));
    const auto of_fragments = std::ranges::find_if(executables, [](const auto& executable) {
      return static_cast<bool>(executable.stages & vk::ShaderStageFlagBits::eFragment);
    });
    if (of_fragments == executables.end()) {
      throw std::runtime_error("the pipeline has no executable of the fragment stage");
    }
    nlohmann::json statistics = nlohmann::json::object();
    for (const auto& one : device_.getPipelineExecutableStatisticsKHR(vk::PipelineExecutableInfoKHR(
             *pipeline, static_cast<std::uint32_t>(of_fragments - executables.begin())))) {
      statistics[one.name.data()] = number_of(one);
    }
    return {{"statistics", statistics}, {"seconds", seconds}};
  }

 private:
  vk::raii::Device make_device() const {
    const float priority = 1.0f;
    const vk::DeviceQueueCreateInfo queue({}, 0, 1, &priority);
    const vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR features(true);
    return {gpu_, vk::DeviceCreateInfo({}, queue, {}, kStatisticsExtension, nullptr, &features)};
  }

  vk::raii::DescriptorSetLayout make_set() const {
    std::array<vk::DescriptorSetLayoutBinding, kSamplers> bindings;
    for (std::uint32_t i = 0; i < kSamplers; ++i) {
      bindings[i] = {i, vk::DescriptorType::eCombinedImageSampler, 1, vk::ShaderStageFlagBits::eFragment};
    }
    return {device_, vk::DescriptorSetLayoutCreateInfo({}, bindings)};
  }

  vk::raii::PipelineLayout make_layout() const {
    const vk::PushConstantRange range(vk::ShaderStageFlagBits::eFragment, 0, kPushConstantBytes);
    return {device_, vk::PipelineLayoutCreateInfo({}, *set_, range)};
  }

  vk::raii::RenderPass make_pass() const {
    const auto colour = vk::AttachmentDescription()
                            .setFormat(vk::Format::eR8G8B8A8Unorm)
                            .setLoadOp(vk::AttachmentLoadOp::eDontCare)
                            .setStencilLoadOp(vk::AttachmentLoadOp::eDontCare)
                            .setStencilStoreOp(vk::AttachmentStoreOp::eDontCare)
                            .setFinalLayout(vk::ImageLayout::eColorAttachmentOptimal);
    const vk::AttachmentReference reference(0, vk::ImageLayout::eColorAttachmentOptimal);
    const auto subpass = vk::SubpassDescription().setColorAttachments(reference);
    return {device_, vk::RenderPassCreateInfo({}, colour, subpass)};
  }

  vk::ApplicationInfo application_ = vk::ApplicationInfo().setApiVersion(VK_API_VERSION_1_1);
  vk::raii::Context context_;  // which loads libvulkan
  vk::raii::Instance instance_{context_, vk::InstanceCreateInfo({}, &application_)};
  vk::raii::PhysicalDevice gpu_ = first_gpu(instance_);
  vk::raii::Device device_ = make_device();
  vk::raii::DescriptorSetLayout set_ = make_set();
  vk::raii::PipelineLayout layout_ = make_layout();
  vk::raii::RenderPass pass_ = make_pass();
  Words vertex_words_ = vertex_shader();
  vk::raii::ShaderModule vertex_{device_, vk::ShaderModuleCreateInfo({}, vertex_words_)};
};

Words words_of(const char* file) {
  const auto bytes = read_file(file);
  if (!bytes) throw std::runtime_error(bytes.error().text());
  Words words(bytes->size() / sizeof(std::uint32_t));
  std::memcpy(words.data(), bytes->data(), words.size() * sizeof(std::uint32_t));
  return words;
}

// The value of a function, or its error, behind the subject of it.
template <typename Function>
bool print(const char* of, Function function) {
  bool is_error = false;
  nlohmann::json json;
  try {
    json = function();
  } catch (const std::exception& error) {
    json = {{"error", fmt::format("{}{}", of, error.what())}};
    is_error = true;
  }
  fmt::print("{}\n", dump(json));
  std::fflush(stdout);  // whoever reads must have it, should the next shader be the driver's end
  return !is_error;
}

}  // namespace

int shader_statistics_command(std::span<const char* const> files) {
  std::optional<Compiler> compiler;
  if (!print("libvulkan and its driver: ", [&] { return compiler.emplace().description(); })) return EXIT_FAILURE;
  for (const char* const file : files) print("", [&] { return compiler->compile(words_of(file)); });
  return EXIT_SUCCESS;
}

}  // namespace hn
