#include "lib/schemes/tlsph/boundary/support_work.hpp"

#include <algorithm>
#include <numeric>

namespace plumb {
namespace {

/// One component that moves with that velocity.
struct Mover {
  Index slot;
  int component;
  double velocity;
  auto place() const { return std::pair(slot, component); }
};

template <int d>
std::vector<Mover> movers_of(const Solid<d>& solid, const std::vector<Support<d>>& supports) {
  std::vector<Mover> movers;
  for (const auto& s : supports)
    if (s.velocity != 0) movers.push_back({solid.bonds.slots.of(s.particle), s.component, s.velocity});
  const auto before = [](const Mover& a, const Mover& b) { return a.place() < b.place(); };
  const auto same = [](const Mover& a, const Mover& b) { return a.place() == b.place(); };
  std::sort(movers.begin(), movers.end(), before);
  movers.erase(std::unique(movers.begin(), movers.end(), same), movers.end());
  return movers;
}

}  // namespace

/// What the term and the account share.
template <int d>
struct SupportWork<d>::Account {
  std::vector<Mover> movers;
  std::vector<double> weights;    ///< Stepper::weights; one alone counts at both ends of a step
  std::vector<double> sum, last;  ///< per block, of this step and of its last evaluation [W]
  std::size_t evaluation = 0;     ///< of this step, from 1

  void add(const Solid<d>& solid, const Block& block, BlockForce<d>& force) {
    auto at = std::lower_bound(movers.begin(), movers.end(), block.begin(),
                               [](const Mover& mover, Index slot) { return mover.slot < slot; });
    double power = 0;
    for (; at != movers.end() && at->slot < block.end(); ++at)
      power -= solid.volume[at->slot] * force(at->component, at->slot) * at->velocity;
    const Index b = block.begin() / block_slots;
    last[b] = weights[std::min(evaluation, weights.size()) - 1] * power;
    sum[b] += last[b];
  }
};

template <int d>
SupportWork<d>::SupportWork(Solid<d>& solid, const std::vector<Support<d>>& held, const Stepper<d>& stepper) {
  auto movers = movers_of(solid, held);
  auto& terms = solid.terms;
  const auto supports =
      std::find_if(terms.begin(), terms.end(), [](const auto& t) { return t.name == "supports"; });
  if (movers.empty() || supports == terms.end() || stepper.weights.empty()) return;
  account_ = std::make_shared<Account>();
  account_->movers = std::move(movers);
  account_->weights = stepper.weights;
  account_->sum.assign(solid.blocks(), 0.0);
  account_->last = account_->sum;
  Term<d> term;
  term.name = "work of supports";
  term.first = [account = account_](const Solid<d>&, const Block& block, const Instant<d>&) {
    if (block.first_pack == 0) ++account->evaluation;  // read when the first phase is over, in all threads
  };
  term.second = [account = account_](const Solid<d>& of, const Block& block, const Instant<d>&,
                                     BlockForce<d>& force) { account->add(of, block, force); };
  terms.insert(supports, std::move(term));
}

template <int d>
void SupportWork<d>::resume(double done, double power) {
  done_ = done;
  power_ = power;
}

template <int d>
void SupportWork<d>::observe(const State<d>& state) {
  const double dt = state.time - time_;
  time_ = state.time;
  if (!account_ || account_->evaluation == 0) return;  // the start of a run
  Account& a = *account_;
  done_ += dt * std::accumulate(a.sum.begin(), a.sum.end(), power_);
  power_ = a.weights.size() == 1 ? std::accumulate(a.last.begin(), a.last.end(), 0.0) : 0.0;
  std::fill(a.sum.begin(), a.sum.end(), 0.0);
  a.evaluation = 0;
}

template class SupportWork<1>;
template class SupportWork<2>;
template class SupportWork<3>;

}  // namespace plumb
