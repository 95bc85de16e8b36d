#include "gpu/way/evaluator.hpp"

#include <utility>

namespace hn {
namespace {

class WayEvaluator final : public Evaluator {
 public:
  WayEvaluator(Way way, std::unique_ptr<Evaluator> inner) : way_(std::move(way)), inner_(std::move(inner)) {
    info_ = inner_->info();
    info_.languages = {.profiles = way_.sources()};
  }

  const ContextInfo& info() const override { return info_; }
  std::string unsupported(const Profile& profile, Stage stage) const override {
    auto reason = unsupported_reason(profile, info_.languages);
    return reason.empty() && stage != Stage::compute ? "functions are evaluated in compute shaders here" : reason;
  }
  Result<std::unique_ptr<Evaluable>> build(const SourceSet&, const Evaluation&, std::string_view) override {
    return fail("ways are not written yet");
  }
  bool is_lost() const override { return inner_->is_lost(); }
  const Context* context() const override { return nullptr; }
  const Way* way() const override { return &way_; }

 private:
  Way way_;
  std::unique_ptr<Evaluator> inner_;
  ContextInfo info_;
};

}  // namespace

std::unique_ptr<Evaluator> evaluator_through(Way way, std::unique_ptr<Evaluator> inner, const ReferenceCompiler&,
                                             WgslText, Translating) {
  return std::make_unique<WayEvaluator>(std::move(way), std::move(inner));
}

}  // namespace hn
