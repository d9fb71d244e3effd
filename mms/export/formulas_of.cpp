#include "mms/export/formulas_of.hpp"

#include "lib/core/dimension.hpp"
#include "lib/material/laws.hpp"
#include "mms/catalogue.hpp"
#include "mms/manufactured.hpp"

namespace plumb::mms {
namespace {

template <int d, class S>
void write_motion(const S& solution, SolutionFormulas& out) {
  Vec<d, Written> X;
  for (int A = 0; A < d; ++A) X[A] = Written(out.list, out.list.variable(A));
  const Vec<d, Written> u = solution.template displacement<d>(X, Written(out.list, out.list.variable(d)));
  for (int i = 0; i < d; ++i) {
    out.u.push_back(u[i].in(out.list));
    out.v.push_back(out.list.derivative(out.u.back(), d));
    out.a.push_back(out.list.derivative(out.v.back(), d));
  }
  for (int i = 0; i < d; ++i)
    for (int A = 0; A < d; ++A) {
      const int slope = out.list.derivative(out.u[static_cast<std::size_t>(i)], A);
      out.F.push_back(i == A ? out.list.make(Term::Op::sum, out.list.constant(1), slope) : slope);
    }
}

template <int d, class M>
void write_stress(const M& law, double density, SolutionFormulas& out) {
  Mat<d, Written> F;
  for (int i = 0; i < d; ++i)
    for (int A = 0; A < d; ++A) F(i, A) = Written(out.list, out.F[static_cast<std::size_t>(i * d + A)]);
  const Mat<d, Written> P = law.first_piola(F);
  Formulas& list = out.list;
  for (int i = 0; i < d; ++i) {
    int force = list.make(Term::Op::product, list.constant(density), out.a[static_cast<std::size_t>(i)]);
    for (int A = 0; A < d; ++A) {
      out.P.push_back(P(i, A).in(list));
      force = list.make(Term::Op::difference, force, list.derivative(out.P.back(), A));
    }
    out.b.push_back(force);
  }
}

template <int d>
void write(std::string_view name, const Parameters& values, const Elastic& elastic, const LawChoice& law,
           SolutionFormulas& out) {
  with_named(SolutionCatalogue{}, name, [&]<class S>(Type<S>) {
    if constexpr (S::template in_dimension<d>) write_motion<d>(S(values, elastic), out);
  });
  if (out.u.empty())
    throw InputError("the solution " + std::string(name) + " does not exist in " + std::to_string(d) + "D",
                     "", "See `plumb mms --list`.");
  with_named(ElasticLaws{}, law.name,
             [&]<class M>(Type<M>) { write_stress<d>(make_law<M>(elastic, law), elastic.density, out); });
}

}  // namespace

SolutionFormulas formulas_of(std::string_view name, int dimension,
                             const std::map<std::string, double>& parameters, const Elastic& elastic,
                             const LawChoice& law) {
  Parameters values = solution_entry(name).parameters;
  for (const auto& entry : parameters) values.set(entry.first, entry.second);
  require_law(law, elastic);
  if (has_history(law.name))
    throw InputError(law.name + " as source text", "its stress depends on what was before",
                     "use libplumbline_c");
  if (dimension == 2 && law.plane == Plane::stress)
    throw InputError("plane stress as source text", "F_33 is found by iterations", "use libplumbline_c");
  SolutionFormulas out;
  with_dimension(dimension, [&]<int d>() { write<d>(name, values, elastic, law, out); });
  return out;
}

}  // namespace plumb::mms
