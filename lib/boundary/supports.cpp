#include "plumbline/boundary/supports.hpp"

#include <algorithm>
#include <memory>

namespace plumb {

template <int d>
std::vector<Index> particles_on_face(const Cloud<d>& cloud, int axis, bool upper, Layout layout) {
  const double face = cloud.box.origin[axis] + (upper ? cloud.box.size[axis] : 0);
  // cell layout: the first layer is half a spacing inside (less than one even with jitter), the second one
  // and a half
  const double reach = (layout == Layout::node ? 1e-6 : 0.9) * cloud.spacing;
  return particles_where<d>(cloud, [&](const Vec<d>& X) { return std::abs(X[axis] - face) < reach; });
}

template <int d>
std::vector<Index> particles_where(const Cloud<d>& cloud,
                                   const std::function<bool(const Vec<d>&)>& predicate) {
  std::vector<Index> found;
  for (Index i = 0; i < cloud.size(); ++i)
    if (predicate(cloud.X[i])) found.push_back(i);
  return found;
}

template <int d>
Term<d> support_term(const Solid<d>& solid, std::vector<Support<d>> supports) {
  struct Entry {
    Index slot;
    int component;
    bool operator<(const Entry& other) const {
      return slot != other.slot ? slot < other.slot : component < other.component;
    }
  };
  auto entries = std::make_shared<std::vector<Entry>>();
  entries->reserve(supports.size());
  for (const auto& s : supports) entries->push_back({solid.bonds.slots.of(s.particle), s.component});
  std::sort(entries->begin(), entries->end());
  Term<d> term;
  term.name = "supports";
  term.bytes = entries->size() * sizeof(Entry);
  term.second = [entries](const Solid<d>&, const Block& block, const State<d>&, double,
                          BlockForce<d>& force) {
    auto at = std::lower_bound(entries->begin(), entries->end(), Entry{block.begin(), 0});
    for (; at != entries->end() && at->slot < block.end(); ++at) force(at->component, at->slot) = 0;
  };
  return term;
}

template <int d>
void impose(const Solid<d>& solid, const std::vector<Support<d>>& supports, State<d>& state) {
  for (const auto& s : supports) state.v[s.component][solid.bonds.slots.of(s.particle)] = s.velocity;
}

template std::vector<Index> particles_on_face<2>(const Cloud<2>&, int, bool, Layout);
template std::vector<Index> particles_on_face<3>(const Cloud<3>&, int, bool, Layout);
template std::vector<Index> particles_where<2>(const Cloud<2>&, const std::function<bool(const Vec<2>&)>&);
template std::vector<Index> particles_where<3>(const Cloud<3>&, const std::function<bool(const Vec<3>&)>&);
template Term<2> support_term<2>(const Solid<2>&, std::vector<Support<2>>);
template Term<3> support_term<3>(const Solid<3>&, std::vector<Support<3>>);
template void impose<2>(const Solid<2>&, const std::vector<Support<2>>&, State<2>&);
template void impose<3>(const Solid<3>&, const std::vector<Support<3>>&, State<3>&);

}  // namespace plumb
