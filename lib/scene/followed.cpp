#include "lib/scene/followed.hpp"

#include <fmt/format.h>

#include "lib/core/error.hpp"
#include "lib/schemes/tlsph/loops/body_history.hpp"

namespace plumb {
namespace {

/// Begins the names of fields with the work of actions, followed by the forces that count for the next step, too.
const std::string work_field = "work of ";

/// Puts what gathered() has made back into its place.
template <int d>
void scatter(const Solid<d>& solid, const SavedField* saved, Field& field, int first = 0,
             int components = d) {
  const auto needed = static_cast<std::size_t>(solid.cloud.size() * components);
  if (!saved || saved->values.size() != needed)
    throw InputError("the checkpoint has another number of particles",
                     fmt::format("{}, the scene {}",
                                 saved ? saved->values.size() / static_cast<std::size_t>(components) : 0,
                                 solid.cloud.size()),
                     "");
  for (Index i = 0; i < solid.cloud.size(); ++i)
    for (int k = 0; k < components; ++k)
      field[first + k][solid.bonds.slots.of(i)] = saved->values[i * components + k];
}

}  // namespace

template <int d>
SavedState save(const Followed<d>& followed) {
  const Solid<d>& solid = followed.body->solid;
  const State<d>& state = followed.body->state;
  SavedState saved{{state.time, state.step}, followed.body->integrator.workspace->work, {}};
  saved.fields.push_back(gathered("displacement", solid, state.u));
  saved.fields.push_back(gathered("velocity", solid, state.v));
  const auto& carried = followed.body->integrator.carried;
  if (const Field* field = carried ? carried() : nullptr)
    saved.fields.push_back(gathered("integrator", solid, *field));
  for (KeptWork work : followed.work ? followed.work->save() : followed.work_before) {
    work.carried.insert(work.carried.begin(), work.done);
    saved.fields.push_back(
        {work_field + work.action, static_cast<int>(work.carried.size()), std::move(work.carried)});
  }
  if (const auto& history = solid.sweeps.history)
    for (const HistoryValue& value : history->values)
      saved.fields.push_back(gathered(value.name, solid, history->field, value.first, value.components()));
  if (followed.relaxation) saved.fields.push_back({"relaxation", 1, {followed.relaxation->rate()}});
  return saved;
}

template <int d>
void restore(Followed<d>& followed, const SavedState& saved) {
  Solid<d>& solid = followed.body->solid;
  State<d>& state = followed.body->state;
  scatter(solid, field_named(saved.fields, "displacement"), state.u);
  scatter(solid, field_named(saved.fields, "velocity"), state.v);
  if (const auto& history = solid.sweeps.history)
    for (const HistoryValue& value : history->values)
      scatter(solid, field_named(saved.fields, value.name), history->field, value.first, value.components());
  state.time = saved.now.time;
  state.step = saved.now.step;
  const SavedField* integrator = field_named(saved.fields, "integrator");
  if (integrator && followed.body->integrator.carry) {
    Field carried = solid.make_field(d);
    scatter(solid, integrator, carried);
    followed.body->integrator.carry(carried);
  }
  followed.body->integrator.workspace->work = saved.work;
  const SavedField* relaxation = field_named(saved.fields, "relaxation");
  if (followed.relaxation && relaxation) followed.relaxation->set_rate(relaxation->values.at(0));
  for (const SavedField& field : saved.fields)
    if (field.name.starts_with(work_field) && !field.values.empty())
      followed.work_before.push_back({field.name.substr(work_field.size()),
                                      field.values[0],
                                      {field.values.begin() + 1, field.values.end()}});
  followed.goes_on = true;
}

#define PLUMBLINE_INSTANTIATE(d)                   \
  template SavedState save<d>(const Followed<d>&); \
  template void restore<d>(Followed<d>&, const SavedState&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
