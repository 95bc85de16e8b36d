#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "bake/expression_program.hpp"
#include "bake/positions.hpp"
#include "base/file.hpp"
#include "base/process.hpp"

namespace hn {
namespace {

// Points that a process computes at a time. Few enough that the line of progress moves.
constexpr std::size_t kBand = 4096;
constexpr int kPatience = 100;  // milliseconds until a reader looks whether it is to stop

// How the rows are shared among processes.
struct Bands {
  std::size_t width;
  std::size_t rows;       // in all
  std::size_t each;       // rows of a band
  std::size_t processes;  // band i belongs to process i % processes

  std::size_t count() const { return (rows + each - 1) / each; }
  std::size_t end_of(std::size_t band) const { return std::min((band + 1) * each, rows); }
};

// A child that is gone with this object.
class Child {
 public:
  explicit Child(Process process) : process_(std::move(process)) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (process_.pid != 0) end();
  }

  int fd() const { return process_.reports.get(); }
  // Kills it if it runs; by waitpid.
  int end() {
    kill(process_.pid, SIGKILL);
    return wait();
  }
  int wait() {
    int status = 0;
    while (waitpid(process_.pid, &status, 0) < 0 && errno == EINTR) {
    }
    process_.pid = 0;
    return status;
  }

 private:
  Process process_;
};

// The likely fault of a program that ends so.
std::string_view likely_cause(int status) {
  if (!WIFSIGNALED(status)) return "";
  switch (WTERMSIG(status)) {
    case SIGFPE:
    case SIGILL:  // what compilers make of a division by what is always 0
      return "; was an int divided by 0?";
    case SIGSEGV:
      return "; does a function call itself without an end, or is an index beyond its array?";
    default:
      return "";
  }
}

enum class Arrival { kAll, kEnded, kStopped };

// So many bytes, unless the child ends before, or somebody else has failed.
Arrival read_all(int fd, char* to, std::size_t size, const std::atomic<bool>& stop) {
  while (size > 0) {
    pollfd waiting{fd, POLLIN, 0};
    const int ready = poll(&waiting, 1, kPatience);
    if (stop) return Arrival::kStopped;
    if (ready <= 0) continue;
    const ssize_t got = read(fd, to, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return Arrival::kEnded;
    to += got;
    size -= static_cast<std::size_t>(got);
  }
  return Arrival::kAll;
}

class Computation {
 public:
  Computation(const ExpressionProgram& program, const Bands& bands, std::vector<std::size_t> chosen, Planes& planes,
              const RowsDone& rows_done)
      : program_(program), bands_(bands), chosen_(std::move(chosen)), planes_(planes), rows_done_(rows_done) {}

  // In a thread of its own.
  void run(std::size_t number) {
    const auto done = read_process(number);
    if (done) return;
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = done.error();
    stop_ = true;  // only now: the others fail of it
  }

  const std::optional<Error>& failure() const { return failure_; }

 private:
  Result<Process> start(std::size_t number) {
    // One at a time: until a pipe is closed on exec, a process that is started meanwhile would keep it open.
    const std::lock_guard lock(mutex_);
    return start_process({.program = program_.path().string(),
                          .name = "hn-bake: expression",
                          .arguments = {program_.axes().string(), std::to_string(number),
                                        std::to_string(bands_.processes), std::to_string(bands_.each)}});
  }

  Result<void> read_process(std::size_t number) {
    HN_TRY(Process process, start(number));
    Child child(std::move(process));
    std::vector<float> values;
    for (std::size_t band = number; band < bands_.count(); band += bands_.processes) {
      const std::size_t first = band * bands_.each;
      const std::size_t points = (bands_.end_of(band) - first) * bands_.width;
      values.resize(points * program_.components().size());
      const auto arrived =
          read_all(child.fd(), reinterpret_cast<char*>(values.data()), values.size() * sizeof(float), stop_);
      if (arrived == Arrival::kStopped) return fail("stopped");
      if (arrived == Arrival::kEnded) {
        const int status = child.wait();
        return fail(fmt::format("the expression {} while it computed rows {} to {}, counted from 0{}",
                                describe_end(status), first, bands_.end_of(band) - 1, likely_cause(status)));
      }
      for (std::size_t i = 0; i < chosen_.size(); ++i) {
        const auto from = values.begin() + static_cast<std::ptrdiff_t>(chosen_[i] * points);
        std::copy_n(from, points, planes_.planes[i].values.begin() + static_cast<std::ptrdiff_t>(first * bands_.width));
      }
      if (rows_done_) rows_done_(bands_.end_of(band) - first);
    }
    return {};
  }

  const ExpressionProgram& program_;
  const Bands& bands_;
  const std::vector<std::size_t> chosen_;
  Planes& planes_;
  const RowsDone& rows_done_;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::optional<Error> failure_;
};

// As the program reads them: of each axis the cells, the places in them, and the positions.
std::string bytes_of_axes(const BakeOptions& options) {
  std::string bytes;
  for (std::size_t i = 0; i < options.size.size(); ++i) {
    const Axis axis = axis_of(options.origin[i], options.cells[i], options.size[i]);
    bytes += bytes_of(std::span(axis.cell));
    bytes += bytes_of(std::span(axis.f));
    bytes += bytes_of(std::span(axis.p));
  }
  return bytes;
}

}  // namespace

Result<Planes> compute(const ExpressionProgram& program, const BakeOptions& options, const RowsDone& rows_done) {
  const auto chosen = chosen_components(program.components(), options);
  Bands bands{static_cast<std::size_t>(options.size[0]), 1, 1, 1};
  for (std::size_t axis = 1; axis < options.size.size(); ++axis)
    bands.rows *= static_cast<std::size_t>(options.size[axis]);
  bands.each = std::max<std::size_t>(kBand / bands.width, 1);
  const std::size_t wanted =
      options.threads > 0 ? static_cast<std::size_t>(options.threads) : std::thread::hardware_concurrency();
  bands.processes = std::clamp<std::size_t>(wanted, 1, bands.count());
  HN_DO(write_file(program.axes(), bytes_of_axes(options)));

  Planes planes;
  for (const std::size_t component : chosen) {
    planes.planes.push_back({program.components()[component], std::vector<float>(bands.width * bands.rows), {}});
  }
  Computation computation(program, bands, chosen, planes, rows_done);
  const int processes = static_cast<int>(bands.processes);
  hashnoise::threads(processes)(processes, [&](int number) { computation.run(static_cast<std::size_t>(number)); });
  if (computation.failure()) return tl::unexpected(*computation.failure());
  for (Plane& plane : planes.planes) plane.range = range_of(plane.values);
  return planes;
}

}  // namespace hn
