// Times programs against each other: in rounds, so that what slows the machine down for a while slows all of them.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "gpu/gpu.hpp"

namespace hn {

// Seconds of a piece of work, a sample per round.
struct Timing {
  std::vector<double> samples;

  double median() const;
  double spread() const;  // half the distance between the quartiles
};

// A quotient, and half the distance between the quartiles of its samples. NaN where it is unknown.
struct Ratio {
  double value = std::numeric_limits<double>::quiet_NaN();
  double spread = std::numeric_limits<double>::quiet_NaN();

  bool known() const { return value == value; }
};
// "1.23 ± 0.04"
std::string text_of(const Ratio& ratio);

// The time of some work over that of the reference, round by round, after the time of what is empty is taken off both.
Ratio ratio(const Timing& timing, const Timing& reference, const Timing& empty);

// The work to time: a program drawn over a rectangle of pixels.
struct Workload {
  const Program* program;
  int width;
  int height;
  int iterations = 1;  // its uniform of that name, if it has one
};

enum class Clock {
  query,  // GL_TIME_ELAPSED
  wall,   // the time that passes until glFinish returns
};
std::string_view name_of(Clock clock);

// Why a clock is used. The timer query is believed if four times the pixels, four times the iterations and four draws
// each take 3 to 5 times as long: on llvmpipe it measures nothing that grows with the work.
struct Gate {
  Clock clock = Clock::wall;
  double pixels = 0.0;      // how many times as long four times the pixels take by the query
  double iterations = 0.0;  // the same for four times the iterations
  double draws = 0.0;       // the same for four draws
  std::string reason;
};

// The verdict on a query by these three numbers.
Gate judge_query(double pixels, double iterations, double draws);

class Stopwatch {
 public:
  explicit Stopwatch(const Context& context);
  ~Stopwatch();
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

  // Decides which clock to use, by a workload whose time must grow with its iterations.
  const Gate& choose_clock(const Workload& workload);
  const Gate& gate() const { return gate_; }

  // The smallest square of pixels and number of iterations that keep the driver busy for some milliseconds.
  Result<Workload> sufficient_load(const Program& program);

  // A sample of each workload per round, in turns. A first draw of each is not timed: drivers compile then.
  Result<std::vector<Timing>> measure(std::span<const Workload> workloads, int rounds);

  // Seconds until a first draw over few pixels is done.
  double first_draw(const Program& program);

 private:
  // Everything but the draws; returns the place of the uniform "draw_number".
  GLint prepare(const Workload& workload);
  void draw(int times, GLint draw_number);
  double seconds(const Workload& workload, int draws, Clock clock);
  int draws_per_sample(const Workload& workload);

  const GladGLContext& gl_;
  Gate gate_;
  GLuint vertex_array_ = 0;
  GLuint framebuffer_ = 0;
  GLuint renderbuffer_ = 0;
  GLuint query_ = 0;
};

}  // namespace hn
