// A window of GLFW that a fragment shader fills, with Vulkan 1.3. Nothing here has to do with noise.
#pragma once

#define GLFW_INCLUDE_VULKAN
#define VULKAN_HPP_NO_STRUCT_CONSTRUCTORS
#include <GLFW/glfw3.h>

#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <utility>
#include <vulkan/vulkan_raii.hpp>

// GLFW, and a window that cannot be resized.
struct Glfw {
  Glfw(int width, int height) {
    if (glfwInit()) {
      glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
      glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
      window = glfwCreateWindow(width, height, "hashnoise", nullptr, nullptr);
    }
    if (window == nullptr) throw std::runtime_error("There is no window");
  }
  Glfw(const Glfw&) = delete;
  Glfw& operator=(const Glfw&) = delete;
  ~Glfw() { glfwTerminate(); }

  GLFWwindow* window = nullptr;
};

// Push is what the shader takes as push constants.
template <typename Push>
class Window {
 public:
  // The shaders are SPIR-V.
  Window(int width, int height, std::span<const uint32_t> vertex, std::span<const uint32_t> fragment)
      : glfw_(width, height), size_{static_cast<uint32_t>(width), static_cast<uint32_t>(height)} {
    make_pipeline(vertex, fragment);
  }

  GLFWwindow* glfw() const { return glfw_.window; }

  void draw(const Push& push) {
    const uint32_t index = swapchain_.acquireNextImage(UINT64_MAX, nullptr, *acquired_).second;
    (void)device_.waitForFences(*acquired_, true, UINT64_MAX);
    device_.resetFences(*acquired_);
    const vk::raii::ImageView view(device_, vk::ImageViewCreateInfo{.image = images_[index],
                                                                    .viewType = vk::ImageViewType::e2D,
                                                                    .format = kFormat,
                                                                    .subresourceRange = kWhole});
    const vk::raii::CommandBuffers buffers(device_, {.commandPool = *pool_, .commandBufferCount = 1});
    const vk::raii::CommandBuffer& commands = buffers.front();
    commands.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    change(commands, images_[index], vk::ImageLayout::eUndefined, vk::ImageLayout::eColorAttachmentOptimal);
    const vk::RenderingAttachmentInfo target{.imageView = *view,
                                             .imageLayout = vk::ImageLayout::eColorAttachmentOptimal,
                                             .storeOp = vk::AttachmentStoreOp::eStore};
    commands.beginRendering(
        {.renderArea = {.extent = size_}, .layerCount = 1, .colorAttachmentCount = 1, .pColorAttachments = &target});
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline_);
    commands.pushConstants<Push>(*layout_, vk::ShaderStageFlagBits::eFragment, 0, push);
    commands.draw(3, 1, 0, 0);
    commands.endRendering();
    change(commands, images_[index], vk::ImageLayout::eColorAttachmentOptimal, vk::ImageLayout::ePresentSrcKHR);
    commands.end();
    queue_.submit(vk::SubmitInfo{.commandBufferCount = 1, .pCommandBuffers = &*commands});
    queue_.waitIdle();  // a game would go on with the next frame
    (void)queue_.presentKHR({.swapchainCount = 1, .pSwapchains = &*swapchain_, .pImageIndices = &index});
  }

 private:
  static constexpr vk::Format kFormat = vk::Format::eB8G8R8A8Unorm;  // every desktop can show it
  static constexpr vk::ImageSubresourceRange kWhole{
      .aspectMask = vk::ImageAspectFlagBits::eColor, .levelCount = 1, .layerCount = 1};

  vk::raii::Instance make_instance() {
    const vk::ApplicationInfo application{.apiVersion = VK_API_VERSION_1_3};
    uint32_t count = 0;
    const char* const* const extensions = glfwGetRequiredInstanceExtensions(&count);
    return {context_, vk::InstanceCreateInfo{.pApplicationInfo = &application,
                                             .enabledExtensionCount = count,
                                             .ppEnabledExtensionNames = extensions}};
  }

  vk::raii::SurfaceKHR make_surface() {
    VkSurfaceKHR surface = nullptr;
    if (glfwCreateWindowSurface(*instance_, glfw_.window, nullptr, &surface) != VK_SUCCESS) {
      throw std::runtime_error("Vulkan cannot draw on this window");
    }
    return {instance_, surface};
  }

  // The first device that draws on windows, and which family of its queues does.
  std::pair<vk::raii::PhysicalDevice, uint32_t> choose() {
    for (const auto& device : instance_.enumeratePhysicalDevices()) {
      const auto families = device.getQueueFamilyProperties();
      for (uint32_t i = 0; i < families.size(); ++i) {
        if (device.getProperties().apiVersion >= VK_API_VERSION_1_3 &&
            families[i].queueFlags & vk::QueueFlagBits::eGraphics &&
            glfwGetPhysicalDevicePresentationSupport(*instance_, *device, i)) {
          return {device, i};
        }
      }
    }
    throw std::runtime_error("There is no device with Vulkan 1.3 that draws on windows");
  }

  vk::raii::Device make_device() {
    const float priority = 1.0f;
    const vk::DeviceQueueCreateInfo queue{
        .queueFamilyIndex = gpu_.second, .queueCount = 1, .pQueuePriorities = &priority};
    const vk::PhysicalDeviceVulkan13Features features{.synchronization2 = true, .dynamicRendering = true};
    const char* const extension = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
    return {gpu_.first, vk::DeviceCreateInfo{.pNext = &features,
                                             .queueCreateInfoCount = 1,
                                             .pQueueCreateInfos = &queue,
                                             .enabledExtensionCount = 1,
                                             .ppEnabledExtensionNames = &extension}};
  }

  vk::raii::SwapchainKHR make_swapchain() {
    const vk::SurfaceCapabilitiesKHR can = gpu_.first.getSurfaceCapabilitiesKHR(*surface_);
    return {device_, vk::SwapchainCreateInfoKHR{.surface = *surface_,
                                                .minImageCount = can.minImageCount,
                                                .imageFormat = kFormat,
                                                .imageExtent = size_,
                                                .imageArrayLayers = 1,
                                                .imageUsage = vk::ImageUsageFlagBits::eColorAttachment,
                                                .preTransform = can.currentTransform,
                                                .clipped = true}};
  }

  vk::raii::PipelineLayout make_layout() {
    const vk::PushConstantRange range{.stageFlags = vk::ShaderStageFlagBits::eFragment, .size = sizeof(Push)};
    return {device_, vk::PipelineLayoutCreateInfo{.pushConstantRangeCount = 1, .pPushConstantRanges = &range}};
  }

  void make_pipeline(std::span<const uint32_t> vertex_code, std::span<const uint32_t> fragment_code) {
    const auto module = [&](std::span<const uint32_t> code) {
      return vk::raii::ShaderModule(device_, {.codeSize = code.size_bytes(), .pCode = code.data()});
    };
    const vk::raii::ShaderModule vertex = module(vertex_code), fragment = module(fragment_code);
    const std::array<vk::PipelineShaderStageCreateInfo, 2> stages{
        {{.stage = vk::ShaderStageFlagBits::eVertex, .module = *vertex, .pName = "main"},
         {.stage = vk::ShaderStageFlagBits::eFragment, .module = *fragment, .pName = "main"}}};
    const vk::PipelineVertexInputStateCreateInfo no_vertices;
    const vk::PipelineInputAssemblyStateCreateInfo triangles{.topology = vk::PrimitiveTopology::eTriangleList};
    const vk::Viewport viewport{
        .width = static_cast<float>(size_.width), .height = static_cast<float>(size_.height), .maxDepth = 1.0f};
    const vk::Rect2D scissor{.extent = size_};
    const vk::PipelineViewportStateCreateInfo viewports{
        .viewportCount = 1, .pViewports = &viewport, .scissorCount = 1, .pScissors = &scissor};
    const vk::PipelineRasterizationStateCreateInfo filled{.lineWidth = 1.0f};
    const vk::PipelineMultisampleStateCreateInfo one_sample;
    const vk::PipelineColorBlendAttachmentState opaque{.colorWriteMask =
                                                           vk::FlagTraits<vk::ColorComponentFlagBits>::allFlags};
    const vk::PipelineColorBlendStateCreateInfo blending{.attachmentCount = 1, .pAttachments = &opaque};
    const vk::PipelineRenderingCreateInfo target{.colorAttachmentCount = 1, .pColorAttachmentFormats = &kFormat};
    pipeline_ = {device_, nullptr,
                 vk::GraphicsPipelineCreateInfo{.pNext = &target,
                                                .stageCount = stages.size(),
                                                .pStages = stages.data(),
                                                .pVertexInputState = &no_vertices,
                                                .pInputAssemblyState = &triangles,
                                                .pViewportState = &viewports,
                                                .pRasterizationState = &filled,
                                                .pMultisampleState = &one_sample,
                                                .pColorBlendState = &blending,
                                                .layout = *layout_}};
  }

  // Makes an image ready for what is done with it next.
  static void change(const vk::raii::CommandBuffer& commands, vk::Image image, vk::ImageLayout from,
                     vk::ImageLayout to) {
    const vk::ImageMemoryBarrier2 barrier{.srcStageMask = vk::PipelineStageFlagBits2::eColorAttachmentOutput,
                                          .srcAccessMask = vk::AccessFlagBits2::eColorAttachmentWrite,
                                          .dstStageMask = vk::PipelineStageFlagBits2::eColorAttachmentOutput,
                                          .dstAccessMask = vk::AccessFlagBits2::eColorAttachmentWrite,
                                          .oldLayout = from,
                                          .newLayout = to,
                                          .image = image,
                                          .subresourceRange = kWhole};
    commands.pipelineBarrier2({.imageMemoryBarrierCount = 1, .pImageMemoryBarriers = &barrier});
  }

  Glfw glfw_;
  vk::Extent2D size_;
  vk::raii::Context context_;
  vk::raii::Instance instance_ = make_instance();
  vk::raii::SurfaceKHR surface_ = make_surface();
  std::pair<vk::raii::PhysicalDevice, uint32_t> gpu_ = choose();
  vk::raii::Device device_ = make_device();
  vk::raii::Queue queue_{device_, gpu_.second, 0};
  vk::raii::SwapchainKHR swapchain_ = make_swapchain();
  decltype(swapchain_.getImages()) images_ = swapchain_.getImages();
  vk::raii::PipelineLayout layout_ = make_layout();
  vk::raii::Pipeline pipeline_ = nullptr;
  vk::raii::CommandPool pool_{device_, vk::CommandPoolCreateInfo{.queueFamilyIndex = gpu_.second}};
  vk::raii::Fence acquired_{device_, vk::FenceCreateInfo{}};
};
