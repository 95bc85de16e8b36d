#include "bench/fragment_compiler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <nlohmann/json.hpp>
#include <spirv-tools/libspirv.hpp>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/file.hpp"
#include "base/json.hpp"
#include "gpu/driver/library.hpp"
#include "gpu/vulkan/objects.hpp"

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

Result<std::vector<std::uint32_t>> vertex_shader() {
  std::vector<std::uint32_t> words;
  if (!spvtools::SpirvTools(SPV_ENV_VULKAN_1_0).Assemble(kVertexShader, &words)) {
    return fail("the vertex shader cannot be assembled");
  }
  return words;
}

double processor_seconds() {
  // The clock counts all threads, since a driver may compile in others.
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

double number_of(const VkPipelineExecutableStatisticKHR& statistic) {
  switch (statistic.format) {
    case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_BOOL32_KHR:
      return statistic.value.b32;
    case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_INT64_KHR:
      return static_cast<double>(statistic.value.i64);
    case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_FLOAT64_KHR:
      return statistic.value.f64;
    default:
      return static_cast<double>(statistic.value.u64);
  }
}

// The arguments of the pipeline, which point to each other and so stay in one place.
struct PipelineState {
  PipelineState(VkShaderModule vertex, VkShaderModule fragment, VkPipelineLayout layout, VkRenderPass pass) {
    stages[0].stage = VK_SHADER_STAGE_VERTEX_BIT;
    stages[0].module = vertex;
    stages[1].stage = VK_SHADER_STAGE_FRAGMENT_BIT;
    stages[1].module = fragment;
    for (VkPipelineShaderStageCreateInfo& stage : stages) {
      stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
      stage.pName = "main";
    }
    binding.stride = 4 * sizeof(float);
    attribute.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    input.vertexBindingDescriptionCount = 1;
    input.pVertexBindingDescriptions = &binding;
    input.vertexAttributeDescriptionCount = 1;
    input.pVertexAttributeDescriptions = &attribute;
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    viewport.viewportCount = 1;
    viewport.scissorCount = 1;
    raster.lineWidth = 1.0f;
    samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    target.colorWriteMask =
        VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    blend.attachmentCount = 1;
    blend.pAttachments = &target;
    dynamic.dynamicStateCount = static_cast<std::uint32_t>(dynamic_states.size());
    dynamic.pDynamicStates = dynamic_states.data();

    info.flags = VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR;
    info.stageCount = static_cast<std::uint32_t>(stages.size());
    info.pStages = stages.data();
    info.pVertexInputState = &input;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &samples;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamic;
    info.layout = layout;
    info.renderPass = pass;
  }
  PipelineState(const PipelineState&) = delete;
  PipelineState& operator=(const PipelineState&) = delete;

  std::array<VkPipelineShaderStageCreateInfo, 2> stages{};
  VkVertexInputBindingDescription binding{};
  VkVertexInputAttributeDescription attribute{};
  VkPipelineVertexInputStateCreateInfo input =
      of_type<VkPipelineVertexInputStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO);
  VkPipelineInputAssemblyStateCreateInfo assembly =
      of_type<VkPipelineInputAssemblyStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO);
  VkPipelineViewportStateCreateInfo viewport =
      of_type<VkPipelineViewportStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO);
  VkPipelineRasterizationStateCreateInfo raster =
      of_type<VkPipelineRasterizationStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO);
  VkPipelineMultisampleStateCreateInfo samples =
      of_type<VkPipelineMultisampleStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO);
  VkPipelineColorBlendAttachmentState target{};
  VkPipelineColorBlendStateCreateInfo blend =
      of_type<VkPipelineColorBlendStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO);
  std::array<VkDynamicState, 2> dynamic_states = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkPipelineDynamicStateCreateInfo dynamic =
      of_type<VkPipelineDynamicStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO);
  VkGraphicsPipelineCreateInfo info =
      of_type<VkGraphicsPipelineCreateInfo>(VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO);
};

class Device final : public FragmentCompiler {
 public:
  explicit Device(Library library)
      : find_(library.function<std::remove_pointer_t<PFN_vkGetInstanceProcAddr>>("vkGetInstanceProcAddr")) {}
  ~Device() override {
    // The objects of the device go before it.
    vertex_ = {};
    pass_ = {};
    layout_ = {};
    set_layout_ = {};
    if (device_ != VK_NULL_HANDLE) call<PFN_vkDestroyDevice>("vkDestroyDevice")(device_, nullptr);
    if (instance_ != VK_NULL_HANDLE) call<PFN_vkDestroyInstance>("vkDestroyInstance")(instance_, nullptr);
  }

  Result<void> start() {
    if (!find_) return fail("libvulkan has no vkGetInstanceProcAddr");
    return create_instance()
        .and_then([&] { return choose_gpu(); })
        .and_then([&] { return create_device(); })
        .and_then([&] { return create_layout(); })
        .and_then([&] { return create_pass(); })
        .and_then([&] { return vertex_shader(); })
        .and_then([&](const auto& words) { return create_module(words); })
        .map([&](UniqueHandle<VkShaderModule> module) { vertex_ = std::move(module); });
  }

  std::uint32_t vendor() const override { return vendor_; }
  const std::string& device() const override { return name_; }
  const std::string& driver_version() const override { return version_; }

  Result<CompiledShader> compile(std::span<const std::uint32_t> fragment_shader) override {
    HN_TRY(const auto fragment, create_module(fragment_shader));
    const PipelineState state(vertex_.get(), fragment.get(), layout_.get(), pass_.get());
    VkPipeline pipeline = VK_NULL_HANDLE;
    const double before = processor_seconds();
    const VkResult made = call<PFN_vkCreateGraphicsPipelines>("vkCreateGraphicsPipelines")(
        device_, VK_NULL_HANDLE, 1, &state.info, nullptr, &pipeline);
    const double seconds = processor_seconds() - before;
    const UniqueHandle<VkPipeline> owned(device_, pipeline, call<PFN_vkDestroyPipeline>("vkDestroyPipeline"));
    if (made != VK_SUCCESS) return refused("vkCreateGraphicsPipelines", made);
    HN_TRY(const auto index, fragment_executable(pipeline));
    HN_TRY(auto found, statistics(pipeline, index));
    return CompiledShader{std::move(found), seconds};
  }

 private:
  template <typename Pointer>
  Pointer call(const char* name) const {
    return reinterpret_cast<Pointer>(find_(instance_, name));
  }

  static tl::unexpected<Error> refused(std::string_view function, VkResult result) {
    return fail(fmt::format("{} returns {}", function, static_cast<int>(result)));
  }

  // Makes one object with a function of the usual form.
  template <typename Handle, typename Create, typename Destroy, typename Info>
  Result<UniqueHandle<Handle>> create(const char* create_name, const char* destroy_name, const Info& info) const {
    Handle handle = VK_NULL_HANDLE;
    const VkResult made = call<Create>(create_name)(device_, &info, nullptr, &handle);
    if (made != VK_SUCCESS) return refused(create_name, made);
    return UniqueHandle<Handle>(device_, handle, call<Destroy>(destroy_name));
  }

  Result<void> create_instance() {
    auto application = of_type<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
    application.apiVersion = VK_API_VERSION_1_1;
    auto info = of_type<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
    info.pApplicationInfo = &application;
    const VkResult made = call<PFN_vkCreateInstance>("vkCreateInstance")(&info, nullptr, &instance_);
    if (made == VK_ERROR_INCOMPATIBLE_DRIVER) return fail("libvulkan finds no driver that works");
    return made == VK_SUCCESS ? Result<void>() : refused("vkCreateInstance", made);
  }

  Result<void> choose_gpu() {
    std::uint32_t count = 1;
    const auto enumerate = call<PFN_vkEnumeratePhysicalDevices>("vkEnumeratePhysicalDevices");
    const VkResult found = enumerate(instance_, &count, &gpu_);
    if ((found != VK_SUCCESS && found != VK_INCOMPLETE) || count == 0) return fail("the driver offers no GPU");
    VkPhysicalDeviceProperties properties{};
    call<PFN_vkGetPhysicalDeviceProperties>("vkGetPhysicalDeviceProperties")(gpu_, &properties);
    vendor_ = properties.vendorID;
    name_ = properties.deviceName;

    const auto list = call<PFN_vkEnumerateDeviceExtensionProperties>("vkEnumerateDeviceExtensionProperties");
    std::uint32_t extension_count = 0;
    list(gpu_, nullptr, &extension_count, nullptr);
    std::vector<VkExtensionProperties> extensions(extension_count);
    list(gpu_, nullptr, &extension_count, extensions.data());
    const bool has_statistics = std::any_of(extensions.begin(), extensions.end(), [](const auto& extension) {
      return std::string_view(extension.extensionName) == kStatisticsExtension;
    });
    if (!has_statistics) return fail(fmt::format("{} has no {}", name_, kStatisticsExtension));
    // This is of Vulkan 1.2, which the loader of Debian 12 hands through; older drivers leave it as it is.
    auto driver = of_type<VkPhysicalDeviceDriverProperties>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES);
    auto more = of_type<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
    more.pNext = &driver;
    call<PFN_vkGetPhysicalDeviceProperties2>("vkGetPhysicalDeviceProperties2")(gpu_, &more);
    version_ = driver.driverInfo;
    return {};
  }

  Result<void> create_device() {
    const float priority = 1.0f;
    auto queue = of_type<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    auto features = of_type<VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR);
    features.pipelineExecutableInfo = VK_TRUE;
    auto info = of_type<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
    info.pNext = &features;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = &kStatisticsExtension;
    const VkResult made = call<PFN_vkCreateDevice>("vkCreateDevice")(gpu_, &info, nullptr, &device_);
    return made == VK_SUCCESS ? Result<void>() : refused("vkCreateDevice", made);
  }

  Result<void> create_layout() {
    std::array<VkDescriptorSetLayoutBinding, kSamplers> bindings{};
    for (std::uint32_t i = 0; i < kSamplers; i++) {
      bindings[i].binding = i;
      bindings[i].descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
      bindings[i].descriptorCount = 1;
      bindings[i].stageFlags = VK_SHADER_STAGE_FRAGMENT_BIT;
    }
    auto set_info = of_type<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
    set_info.bindingCount = kSamplers;
    set_info.pBindings = bindings.data();
    HN_TRY(auto set, create<VkDescriptorSetLayout, PFN_vkCreateDescriptorSetLayout, PFN_vkDestroyDescriptorSetLayout>(
                         "vkCreateDescriptorSetLayout", "vkDestroyDescriptorSetLayout", set_info));
    set_layout_ = std::move(set);

    const VkDescriptorSetLayout set_layout = set_layout_.get();
    const VkPushConstantRange range{VK_SHADER_STAGE_FRAGMENT_BIT, 0, kPushConstantBytes};
    auto info = of_type<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
    info.setLayoutCount = 1;
    info.pSetLayouts = &set_layout;
    info.pushConstantRangeCount = 1;
    info.pPushConstantRanges = &range;
    return create<VkPipelineLayout, PFN_vkCreatePipelineLayout, PFN_vkDestroyPipelineLayout>(
               "vkCreatePipelineLayout", "vkDestroyPipelineLayout", info)
        .map([&](UniqueHandle<VkPipelineLayout> layout) { layout_ = std::move(layout); });
  }

  Result<void> create_pass() {
    VkAttachmentDescription colour{};
    colour.format = VK_FORMAT_R8G8B8A8_UNORM;
    colour.samples = VK_SAMPLE_COUNT_1_BIT;
    colour.loadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    colour.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    colour.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    colour.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    colour.finalLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &reference;
    auto info = of_type<VkRenderPassCreateInfo>(VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO);
    info.attachmentCount = 1;
    info.pAttachments = &colour;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    return create<VkRenderPass, PFN_vkCreateRenderPass, PFN_vkDestroyRenderPass>("vkCreateRenderPass",
                                                                                 "vkDestroyRenderPass", info)
        .map([&](UniqueHandle<VkRenderPass> pass) { pass_ = std::move(pass); });
  }

  Result<UniqueHandle<VkShaderModule>> create_module(std::span<const std::uint32_t> words) const {
    auto info = of_type<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
    info.codeSize = words.size_bytes();
    info.pCode = words.data();
    return create<VkShaderModule, PFN_vkCreateShaderModule, PFN_vkDestroyShaderModule>("vkCreateShaderModule",
                                                                                       "vkDestroyShaderModule", info);
  }

  Result<std::uint32_t> fragment_executable(VkPipeline pipeline) const {
    auto info = of_type<VkPipelineInfoKHR>(VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR);
    info.pipeline = pipeline;
    const auto list = call<PFN_vkGetPipelineExecutablePropertiesKHR>("vkGetPipelineExecutablePropertiesKHR");
    std::uint32_t count = 0;
    list(device_, &info, &count, nullptr);
    std::vector executables(
        count, of_type<VkPipelineExecutablePropertiesKHR>(VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR));
    list(device_, &info, &count, executables.data());
    for (std::uint32_t i = 0; i < count; i++) {
      if (executables[i].stages & VK_SHADER_STAGE_FRAGMENT_BIT) return i;
    }
    return fail("the pipeline has no executable of the fragment stage");
  }

  Result<ShaderStatistics> statistics(VkPipeline pipeline, std::uint32_t executable) const {
    auto info = of_type<VkPipelineExecutableInfoKHR>(VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR);
    info.pipeline = pipeline;
    info.executableIndex = executable;
    const auto list = call<PFN_vkGetPipelineExecutableStatisticsKHR>("vkGetPipelineExecutableStatisticsKHR");
    std::uint32_t count = 0;
    list(device_, &info, &count, nullptr);
    std::vector values(count,
                       of_type<VkPipelineExecutableStatisticKHR>(VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR));
    list(device_, &info, &count, values.data());

    ShaderStatistics result;
    for (const VkPipelineExecutableStatisticKHR& value : values) result.emplace(value.name, number_of(value));
    return result;
  }

  PFN_vkGetInstanceProcAddr find_;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkPhysicalDevice gpu_ = VK_NULL_HANDLE;
  std::uint32_t vendor_ = 0;
  std::string name_;
  std::string version_;
  VkDevice device_ = VK_NULL_HANDLE;
  UniqueHandle<VkDescriptorSetLayout> set_layout_;
  UniqueHandle<VkPipelineLayout> layout_;
  UniqueHandle<VkRenderPass> pass_;
  UniqueHandle<VkShaderModule> vertex_;
};

}  // namespace

Result<std::unique_ptr<FragmentCompiler>> FragmentCompiler::open() {
  const auto library = Library::open({"libvulkan.so.1", "libvulkan.so"});
  if (!library) return fail("libvulkan is not here: " + library.error().message);
  auto device = std::make_unique<Device>(*library);
  HN_DO(device->start());
  return device;
}

int shader_statistics_command(std::span<const char* const> files) {
  const auto print = [](const nlohmann::json& json) {
    fmt::print("{}\n", dump(json));
    std::fflush(stdout);  // whoever reads must have it, should the next shader be the driver's end
  };
  const auto print_error = [&](const Error& error) { print({{"error", error.text()}}); };
  const auto compiler = FragmentCompiler::open();
  if (!compiler) {
    print_error(compiler.error());
    return EXIT_FAILURE;
  }
  print({{"device", (*compiler)->device()}, {"driver", (*compiler)->driver_version()}});
  for (const char* const file : files) {
    const auto compiled = read_file(file).and_then([&](const std::string& bytes) {
      std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
      std::memcpy(words.data(), bytes.data(), words.size() * sizeof(std::uint32_t));
      return (*compiler)->compile(words);
    });
    if (compiled) {
      print({{"statistics", compiled->statistics}, {"seconds", compiled->seconds}});
    } else {
      print_error(compiled.error());
    }
  }
  return EXIT_SUCCESS;
}

}  // namespace hn
