#include "bench/timing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace hn {
namespace {

// The value below which a part of the sorted samples lies, between two of them if need be.
double quantile(std::vector<double> samples, double part) {
  if (samples.empty()) return 0.0;
  std::sort(samples.begin(), samples.end());
  const double place = part * static_cast<double>(samples.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, samples.size() - 1);
  const double rest = place - static_cast<double>(below);
  return samples[below] * (1.0 - rest) + samples[above] * rest;
}

}  // namespace

double Timing::median() const { return quantile(samples, 0.5); }
double Timing::spread() const { return (quantile(samples, 0.75) - quantile(samples, 0.25)) / 2.0; }

Ratio ratio(const Timing& timing, const Timing& reference, const Timing& empty) {
  const std::size_t rounds = std::min({timing.samples.size(), reference.samples.size(), empty.samples.size()});
  Timing ratios;
  for (std::size_t i = 0; i < rounds; ++i) {
    const double base = reference.samples[i] - empty.samples[i];
    if (base > 0.0) ratios.samples.push_back((timing.samples[i] - empty.samples[i]) / base);
  }
  // Where the reference seldom takes longer than nothing, the remaining rounds prove nothing.
  if (ratios.samples.empty() || 2 * ratios.samples.size() < rounds) return {};
  return {ratios.median(), ratios.spread()};
}

std::string text_of(const Ratio& ratio) {
  return ratio.known() ? fmt::format("{:.2f} ± {:.2f}", ratio.value, ratio.spread) : "cannot be told";
}

namespace {

// The largest picture that is drawn. OpenGL 3.1 has 1024 at the least, everything that we know 4096 and more.
constexpr int kLargestSide = 4096;

// A sample should be long against the resolution of its clock and what a start and a glFinish cost.
constexpr double kSampleSeconds[] = {2e-3, 8e-3};  // by query, by wall

}  // namespace

std::string_view name_of(Clock clock) { return clock == Clock::query ? "timer query" : "wall time around glFinish"; }

Gate judge_query(double pixels, double iterations, double draws) {
  const auto grows = [](double factor) { return factor >= 3.0 && factor <= 5.0; };
  const bool believed = grows(pixels) && grows(iterations) && grows(draws);
  return {believed ? Clock::query : Clock::wall, pixels, iterations, draws,
          fmt::format("by GL_TIME_ELAPSED 4 times the pixels take {:.3g} times as long, 4 times the iterations {:.3g} "
                      "times, 4 draws {:.3g} times; it is {}",
                      pixels, iterations, draws, believed ? "believed" : "not believed: each should be 3 to 5")};
}

Stopwatch::Stopwatch(const Context& context) : gl_(context.gl()) {
  gl_.GenVertexArrays(1, &vertex_array_);
  gl_.GenRenderbuffers(1, &renderbuffer_);
  gl_.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer_);
  gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, kLargestSide, kLargestSide);
  gl_.GenFramebuffers(1, &framebuffer_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer_);
  // GL_TIME_ELAPSED came with OpenGL 3.3.
  if (gl_.GetQueryObjectui64v) gl_.GenQueries(1, &query_);
  gate_.reason = query_ == 0 ? "this OpenGL has no timer query" : "no clock has been chosen";
}

Stopwatch::~Stopwatch() {
  if (query_ != 0) gl_.DeleteQueries(1, &query_);
  gl_.DeleteFramebuffers(1, &framebuffer_);
  gl_.DeleteRenderbuffers(1, &renderbuffer_);
  gl_.DeleteVertexArrays(1, &vertex_array_);
}

GLint Stopwatch::prepare(const Workload& workload) {
  const GLuint id = workload.program->id();
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Viewport(0, 0, workload.width, workload.height);
  gl_.UseProgram(id);
  gl_.BindVertexArray(vertex_array_);
  const GLint iterations = gl_.GetUniformLocation(id, "iterations");
  if (iterations >= 0) gl_.Uniform1i(iterations, workload.iterations);
  return gl_.GetUniformLocation(id, "draw_number");
}

void Stopwatch::draw(int times, GLint draw_number) {
  for (int i = 0; i < times; ++i) {
    if (draw_number >= 0) gl_.Uniform1i(draw_number, i);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    // llvmpipe, and others that render tile by tile, skip what a later draw of the same batch paints over. By the timer
    // query that would have been seen (choose_clock), and there a flush would only hold up a GPU.
    if (gate_.clock == Clock::wall) gl_.Flush();
  }
}

double Stopwatch::seconds(const Workload& workload, int draws, Clock clock) {
  const GLint draw_number = prepare(workload);
  gl_.Finish();
  if (clock == Clock::query) {
    gl_.BeginQuery(GL_TIME_ELAPSED, query_);
    draw(draws, draw_number);
    gl_.EndQuery(GL_TIME_ELAPSED);
    GLuint64 nanoseconds = 0;
    gl_.GetQueryObjectui64v(query_, GL_QUERY_RESULT, &nanoseconds);
    return static_cast<double>(nanoseconds) * 1e-9 / draws;
  }
  const auto start = std::chrono::steady_clock::now();
  draw(draws, draw_number);
  gl_.Finish();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / draws;
}

double Stopwatch::first_draw(const Program& program) { return seconds({&program, 8, 8, 1}, 1, Clock::wall); }

const Gate& Stopwatch::choose_clock(const Workload& workload) {
  if (query_ == 0) return gate_;
  gate_.clock = Clock::query;  // draw as the query would be used
  const auto best_of_three = [&](Workload load, int draws) {
    seconds(load, draws, Clock::query);
    return draws * std::min({seconds(load, draws, Clock::query), seconds(load, draws, Clock::query),
                             seconds(load, draws, Clock::query)});
  };
  // Larger than the load, so that what a query costs by itself does not hide how it grows.
  Workload base_load = workload;
  if (base_load.width < kLargestSide / 2) {
    base_load.width *= 2;
    base_load.height *= 2;
  }
  Workload pixels = base_load;
  pixels.width *= 2;
  pixels.height *= 2;
  Workload iterations = base_load;
  iterations.iterations *= 4;
  const double base = std::max(best_of_three(base_load, 1), 1e-9);
  gate_ = judge_query(best_of_three(pixels, 1) / base, best_of_three(iterations, 1) / base,
                      best_of_three(base_load, 4) / base);
  return gate_;
}

Result<Workload> Stopwatch::sufficient_load(const Program& program) {
  // Shorter than this, a draw is mostly overhead.
  constexpr double kEnough = 2e-3;
  // Some iterations at the least, or else the time would not grow with them.
  constexpr std::array<std::array<int, 2>, 8> kLoads = {
      {{32, 8}, {64, 8}, {128, 8}, {256, 8}, {512, 8}, {1024, 8}, {2048, 8}, {2048, 32}}};
  while (gl_.GetError() != GL_NO_ERROR) {
  }
  Workload load{&program, 0, 0, 1};
  for (const auto& [side, iterations] : kLoads) {
    load = {&program, side, side, iterations};
    seconds(load, 1, Clock::wall);
    if (std::min(seconds(load, 1, Clock::wall), seconds(load, 1, Clock::wall)) >= kEnough) break;
  }
  if (const GLenum error = gl_.GetError(); error != GL_NO_ERROR) {
    return fail(fmt::format("OpenGL error {:#06x} while drawing {} x {}", error, load.width, load.height));
  }
  return load;
}

int Stopwatch::draws_per_sample(const Workload& workload) {
  const double target = kSampleSeconds[gate_.clock == Clock::query ? 0 : 1];
  constexpr int kMost = 4096;
  int draws = 1;
  double each = seconds(workload, draws, gate_.clock);
  while (each * draws < target / 4.0 && draws < kMost) {
    draws *= 4;
    each = seconds(workload, draws, gate_.clock);
  }
  return std::clamp(static_cast<int>(std::ceil(target / std::max(each, 1e-9))), 1, kMost);
}

Result<std::vector<Timing>> Stopwatch::measure(std::span<const Workload> workloads, int rounds) {
  while (gl_.GetError() != GL_NO_ERROR) {
  }
  std::vector<Timing> timings(workloads.size());
  std::vector<int> draws;
  for (const Workload& workload : workloads) {
    seconds(workload, 1, Clock::wall);
    draws.push_back(draws_per_sample(workload));
  }
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < workloads.size(); ++i) {
      timings[i].samples.push_back(seconds(workloads[i], draws[i], gate_.clock));
    }
  }
  if (const GLenum error = gl_.GetError(); error != GL_NO_ERROR) {
    return fail(fmt::format("OpenGL error {:#06x} while timing", error));
  }
  return timings;
}

}  // namespace hn
