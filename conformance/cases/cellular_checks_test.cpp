// The checks of cellular noise, on a library with a fault.
#include "cases/faulty_library_fixture.hpp"

namespace hn {
namespace {

class CellularChecks : public FaultyLibrary {};

TEST_F(CellularChecks, PLACEHOLDER) {}

}  // namespace
}  // namespace hn
