// The checks of simplex noise, of phases and of curl, on a library with a fault.
#include "cases/faulty_library_fixture.hpp"

namespace hn {
namespace {

struct Fault {
  std::string_view id;
  std::string_view file;
  std::string_view fault;
};

class SimplexChecks : public FaultyLibrary {
 protected:
  template <std::size_t count>
  void expect_all_caught(const Fault (&faults)[count]) {
    for (const Fault& fault : faults) expect_caught(fault.id, fault.file, fault.fault);
  }
  template <std::size_t count>
  void expect_all_caught(const Replacement (&faults)[count]) {
    for (const Replacement& fault : faults) expect_replaced_caught(fault);
  }
};

// A sign, a factor, components in another order, and a term that is missing.
TEST_F(SimplexChecks, WrongDerivativesAreCaught) {
  constexpr Fault kFaults[] = {
      {"noise2d.simplex_d.lattice.fast.fragment.gl330.derivative", "simplex_d2d.glsl",
       "hn_simplex_d(args) (vec3(1.0, 1.0, 1.01) * hn_simplex_d(args))"},
      {"noise2d.simplex_d_cell.lattice.fixed.fragment.gl330.derivative", "simplex_d2d.glsl",
       "hn_simplex_d(c, args) (vec3(1.0, 1.02, 1.0) * hn_simplex_d(c, args))"},
      {"noise3d.simplex_d.lattice.precise.fragment.gl400.derivative", "simplex_d3d.glsl",
       "hn_simplex_d(args) (vec4(1.0, 1.01, 1.0, 1.0) * hn_simplex_d(args))"},
      {"noise3d.simplex_d_cell_period.lattice.fixed.fragment.gl330.derivative", "simplex_d3d.glsl",
       "hn_simplex_d(t, args) hn_simplex_d(t, args).xzyw"},
      {"noise2d.simplex_d_phase.lattice.fast.fragment.gl330.derivative", "simplex_phase2d.glsl",
       "hn_simplex_d(p, t, args) (vec3(1.0, -1.0, 1.0) * hn_simplex_d(p, t, args))"},
      {"noise3d.perlin_d_phase.lattice.fast.fragment.gl330.derivative", "perlin_phase3d.glsl",
       "hn_perlin_d(p, t, args) (vec4(1.0, 1.0, 1.0, 1.01) * hn_perlin_d(p, t, args))"}};
  expect_all_caught(kFaults);
  constexpr Replacement kTerms[] = {
      {"noise4d.simplex_d.lattice.fast.fragment.gl330.derivative", "detail/falloff.glsl", "hn_float d = g * w - k * x;",
       "hn_float d = g * w;"},
      {"noise2d.simplex_d.lattice.fast.fragment.gl330.derivative", "detail/falloff.glsl", "hn_float d = g * w - k * x;",
       "hn_float d = g * w - 0.99 * k * x;"},
      {"noise2d.phasor_d.lattice.fast.fragment.gl330.derivative", "detail/phasor.glsl",
       "hn_i_minus(fall.x, hn_i_turning(n.y, k))", "hn_i_plus(fall.x, hn_i_turning(n.y, k))"},
      {"noise3d.phasor_d.lattice.fast.fragment.gl330.derivative", "detail/phasor.glsl", "return hn_i_times(n, -x);",
       "return hn_i_times(n, x);"}};
  expect_all_caught(kTerms);
}

// Also at points that are no corners of cells.
TEST_F(SimplexChecks, NoiseThatIsNotZeroAtLatticePointsIsCaught) {
  constexpr Fault kFaults[] = {
      {"noise2d.simplex.lattice.fast.fragment.gl330.zero", "simplex2d.glsl",
       "hn_simplex(args) (hn_simplex(args) + (fract(p.x) == 0.75 ? 0.00001 : 0.0))"},
      {"noise2d.simplex_smooth.lattice.fixed.fragment.gl330.zero", "simplex_smooth2d.glsl",
       "hn_simplex_smooth(args) (hn_simplex_smooth(args) + (fract(p) == vec2(0.5, 0.0) ? 0.00001 : 0.0))"},
      {"noise3d.simplex.lattice.fast.fragment.gl330.zero", "simplex3d.glsl",
       "hn_simplex(args) (hn_simplex(args) + (fract(p.y) == 0.5 ? 0.00001 : 0.0))"}};
  expect_all_caught(kFaults);
}

// On the plane a field without periods repeats after 2^31 cells.
TEST_F(SimplexChecks, AFieldOfTheWrongSizeIsCaught) {
  expect_caught("noise2d.simplex_cell_period.lattice.fast.fragment.gl330.period", "simplex2d.glsl",
                "hn_simplex(t, args) (hn_simplex(t, args) + (period.x <= 0 && cell.x < 0 ? 0.00001 : 0.0))");
}

TEST_F(SimplexChecks, APhaseThatDoesNotLoopIsCaught) {
  constexpr std::string_view kPart = "(turns - trunc(turns))";
  constexpr Replacement kFaults[] = {{"noise2d.simplex_phase.lattice.fast.fragment.gl330.loop", "detail/sine.glsl",
                                      kPart, "(turns - 0.99999f * trunc(turns))"},
                                     {"noise3d.simplex_d_phase_cell_period.lattice.fixed.fragment.gl330.loop",
                                      "detail/sine.glsl", kPart, "(turns - trunc(turns) + 0.0000001f * trunc(turns))"},
                                     // A negative phase that rotates the other way.
                                     {"noise3d.perlin_phase_cell.lattice.precise.fragment.gl400.loop",
                                      "detail/sine.glsl", kPart, "abs(turns - trunc(turns))"},
                                     {"noise2d.phasor.lattice.fixed.fragment.gl330.loop", "detail/sine.glsl", kPart,
                                      "(turns - trunc(turns) + 0.0000001f * trunc(turns))"}};
  expect_all_caught(kFaults);
}

TEST_F(SimplexChecks, HalfATurnThatDoesNotNegateIsCaught) {
  constexpr Fault kFaults[] = {{"noise2d.perlin_phase.lattice.fast.fragment.gl330.half_turn", "perlin_phase2d.glsl",
                                "hn_perlin(p, t, args) (hn_perlin(p, t, args) + 0.0001)"},
                               {"noise3d.simplex_phase_cell.lattice.fixed.fragment.gl330.half_turn",
                                "simplex_phase3d.glsl", "hn_simplex(c, t, args) abs(hn_simplex(c, t, args))"}};
  expect_all_caught(kFaults);
  expect_replaced_caught({"noise2d.simplex_d_phase.lattice.fast.fragment.gl330.half_turn", "detail/sine.glsl",
                          "hn_uint q = angle & 0x7FFFFFFFu;", "hn_uint q = (angle + (angle >> 10u)) & 0x7FFFFFFFu;"});
}

TEST_F(SimplexChecks, AnotherNoiseAtPhaseZeroIsCaught) {
  constexpr Fault kFaults[] = {
      {"noise2d.simplex_phase.lattice.fast.fragment.gl330.phase_zero", "simplex_phase2d.glsl",
       "hn_simplex(p, t, args) hn_simplex(p, t + 0.001, args)"},
      {"noise2d.perlin_d_phase_cell.lattice.precise.fragment.gl400.phase_zero", "perlin_phase2d.glsl",
       "hn_perlin_d(c, t, args) (vec3(1.0, 1.0, 1.001) * hn_perlin_d(c, t, args))"},
      {"noise3d.perlin_phase.lattice.fixed.fragment.gl330.phase_zero", "perlin_phase3d.glsl",
       "hn_perlin(p, t, args) (1.01 * hn_perlin(p, t, args))"}};
  expect_all_caught(kFaults);
}

TEST_F(SimplexChecks, AFieldWithADivergenceIsCaught) {
  constexpr Fault kFaults[] = {
      {"curl.curl2.lattice.fast.fragment.gl330.divergence", "curl2d.glsl",
       "hn_curl(args) (vec2(1.0, -1.0) * hn_curl(args))"},
      {"curl.curl2_cell.lattice.fixed.fragment.gl330.divergence", "curl2d.glsl",
       "hn_curl(c, args) normalize(hn_curl(c, args))"},
      {"curl.curl3.lattice.fast.fragment.gl330.divergence", "curl3d.glsl", "hn_curl(args) normalize(hn_curl(args))"},
      {"curl.curl3.lattice.precise.fragment.gl400.divergence", "curl3d.glsl", "hn_curl(args) hn_curl(args).yxz"},
      {"curl.curl3_cell.lattice.fixed.fragment.gl330.divergence", "curl3d.glsl",
       "hn_curl(c, args) (vec3(1.0, 1.0, -1.0) * hn_curl(c, args))"}};
  expect_all_caught(kFaults);
}

// A kernel that is too large: where another point takes over, the one that is left behind still has a weight.
TEST_F(SimplexChecks, AKernelThatIsTooLargeJumps) {
  constexpr Replacement kFaults[] = {
      {"noise2d.simplex.lattice.fast.fragment.gl330.seams", "detail/triangular_lattice.glsl",
       "HN_I_TRIANGLE_RADIUS 819", "HN_I_TRIANGLE_RADIUS 922"},
      {"noise2d.simplex_d_cell.lattice.fixed.fragment.gl330.seams", "detail/triangular_lattice.glsl",
       "HN_I_TRIANGLE_RADIUS 819", "HN_I_TRIANGLE_RADIUS 870"},
      {"noise3d.simplex.lattice.fast.fragment.gl330.seams", "detail/body_centred_lattice.glsl", "1024, 2", "1229, 2"},
      {"noise3d.simplex_phase_cell.lattice.fixed.fragment.gl330.seams", "detail/body_centred_lattice.glsl", "1024, 2",
       "1229, 2"},
      {"noise4d.simplex.lattice.precise.fragment.gl400.seams", "detail/body_centred_lattice.glsl", "1024, 2",
       "1229, 2"},
      {"noise2d.simplex_smooth.lattice.fast.fragment.gl330.seams", "simplex_smooth2d.glsl", "1024, 1", "1229, 1"},
      {"noise3d.simplex_smooth.lattice.fast.fragment.gl330.seams", "simplex_smooth3d.glsl", "768, 1", "1024, 1"}};
  expect_all_caught(kFaults);
}

// Each kind of plane on its own, from both sides.
TEST_F(SimplexChecks, AJumpAtEachPlaneIsCaught) {
  struct Plane {
    std::string_view id;
    std::string_view file;
    std::string_view name;
    std::string_view side;  // a condition that changes there
  };
  constexpr std::string_view kOffsets = "abs(fract(p + 0.5) - 0.5)";
  constexpr Plane kPlanes[] = {
      {"noise2d.simplex", "simplex2d.glsl", "hn_simplex", "fract(p.x + p.y * 0.5) < 0.5"},
      {"noise2d.simplex", "simplex2d.glsl", "hn_simplex", "fract(p.x - p.y * 0.5) >= 0.5"},
      {"noise2d.simplex", "simplex2d.glsl", "hn_simplex", "fract(p.y) < 0.5"},
      {"noise2d.simplex_smooth", "simplex_smooth2d.glsl", "hn_simplex_smooth", "fract(2.0 * p.x - 0.5) < 0.5"},
      {"noise3d.simplex", "simplex3d.glsl", "hn_simplex", "fract(p.y) <= 0.5"},
      {"noise3d.simplex", "simplex3d.glsl", "hn_simplex", "OFFSETS.x < OFFSETS.z"},
      {"noise4d.simplex", "simplex4d.glsl", "hn_simplex", "OFFSETS.w <= OFFSETS.y"},
      {"noise3d.simplex_smooth", "simplex_smooth3d.glsl", "hn_simplex_smooth", "OFFSETS.x + OFFSETS.y < OFFSETS.z"},
      {"noise3d.simplex_smooth", "simplex_smooth3d.glsl", "hn_simplex_smooth",
       "OFFSETS.x + OFFSETS.z - OFFSETS.y <= 0.5"},
      {"noise3d.perlin", "perlin3d.glsl", "hn_perlin", "fract(p.z) < 0.5"},
      {"noise1d.value", "value1d.glsl", "hn_value", "fract(p) < 0.5"}};
  for (const Plane& plane : kPlanes) {
    const auto id = fmt::format("{}.lattice.fast.fragment.gl330.seams", plane.id);
    expect_faultless_passes(id);
    append(plane.file, fmt::format("#define OFFSETS {}\n#define {}(args) ({}(args) + (({}) ? 0.001 : 0.0))", kOffsets,
                                   plane.name, plane.name, plane.side));
    expect_fails(id, plane.side);
  }
}

}  // namespace
}  // namespace hn
