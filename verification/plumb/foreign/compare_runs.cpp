#include "verification/plumb/foreign/compare_runs.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

#include "lib/core/dimension.hpp"
#include "lib/core/error.hpp"
#include "lib/geometry/neighbours.hpp"
#include "lib/input/document.hpp"

namespace plumb::app {
namespace {

namespace fs = std::filesystem;

/// Times that differ by less than this share of the last one are the same.
constexpr double same_time = 1e-9;

/// The value of an attribute of a tag.
std::string attribute(const std::string& tag, const std::string& name) {
  const std::size_t at = tag.find(name + "=\"");
  if (at == std::string::npos) return "";
  const std::size_t from = at + name.size() + 2;
  return tag.substr(from, tag.find('"', from) - from);
}

std::vector<Instant> instants_of_index(const fs::path& index) {
  std::vector<Instant> instants;
  const std::string text = read_text(index.string());
  for (std::size_t at = text.find("<DataSet"); at != std::string::npos; at = text.find("<DataSet", at + 1)) {
    const std::string tag = text.substr(at, text.find('>', at) - at), time = attribute(tag, "timestep");
    double value = 0;
    const auto [end, error] = std::from_chars(time.data(), time.data() + time.size(), value);
    if (error != std::errc() || end != time.data() + time.size() || !std::isfinite(value))
      throw InputError(fmt::format("{}: \"{}\" is no time", index.string(), time), "", "");
    instants.push_back({(index.parent_path() / attribute(tag, "file")).string(), value});
  }
  return instants;
}

/// A file that has been read last is kept: neighbouring times need it again.
template <int d>
class Frames {
 public:
  Frames(std::vector<Instant> instants, PointOptions options)
      : instants_(std::move(instants)), options_(std::move(options)) {}

  const ForeignField<d>& at(std::size_t k) {
    const auto known = fields_.find(k);
    if (known != fields_.end()) return known->second;
    if (fields_.size() > 2) fields_.erase(fields_.begin());
    const std::string& file = instants_[k].file;
    return fields_.emplace(k, field_as_it_is<d>(read_points(file), file, options_)).first->second;
  }
  const std::vector<Instant>& instants() const { return instants_; }

 private:
  std::vector<Instant> instants_;
  PointOptions options_;
  std::map<std::size_t, ForeignField<d>> fields_;
};

template <int d>
bool same_points(const std::vector<Vec<d>>& a, const std::vector<Vec<d>>& b) {
  if (a.size() != b.size()) return false;
  Vec<d> low = a.front(), high = a.front();
  for (const Vec<d>& X : a) low = low.cwiseMin(X), high = high.cwiseMax(X);
  const double slack = 1e-6 * (high - low).maxCoeff() / std::pow(static_cast<double>(a.size()), 1.0 / d);
  for (std::size_t k = 0; k < a.size(); ++k)
    if (!((a[k] - b[k]).norm() <= slack)) return false;
  return true;
}

/// Weights of the points of `from` whose sum is the value at X of a linear fit to about its 2^d.. 4^d nearest
/// ones; empty if X lies outside of them.
template <int d>
class LinearFit {
 public:
  explicit LinearFit(const std::vector<Vec<d>>& from) : from_(from), search_(from) {
    Vec<d> low = from.front(), high = from.front();
    for (const Vec<d>& X : from) low = low.cwiseMin(X), high = high.cwiseMax(X);
    radius_ = 2 * std::pow((high - low).prod() / static_cast<double>(from.size()), 1.0 / d);
  }
  std::vector<std::pair<std::size_t, double>> weights(const Vec<d>& X) const {
    std::vector<Index> near;
    search_.within(X, radius_, near);
    const auto n = static_cast<Eigen::Index>(near.size());
    if (n < d + 1) return {};
    Eigen::MatrixXd A(n, d + 1);
    Eigen::VectorXd w(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      const Vec<d> r = (from_[static_cast<std::size_t>(near[static_cast<std::size_t>(k)])] - X) / radius_;
      w[k] = 1e-9 + (1 - r.norm()) * (1 - r.norm());
      A(k, 0) = w[k];
      A.row(k).tail(d) = w[k] * r.transpose();
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A);
    if (qr.rank() < d + 1) return {};
    Eigen::MatrixXd all = qr.solve(Eigen::MatrixXd(w.asDiagonal()));
    std::vector<std::pair<std::size_t, double>> found;
    for (Eigen::Index k = 0; k < n; ++k)
      found.emplace_back(static_cast<std::size_t>(near[static_cast<std::size_t>(k)]), all(0, k));
    return found;
  }

 private:
  const std::vector<Vec<d>>& from_;
  NeighbourSearch<d> search_;
  double radius_;
};

/// One instant of B, or two of them with the share of the later one.
struct Moment {
  std::size_t before = 0, after = 0;
  double share = 0;
};

std::optional<Moment> moment_of(const std::vector<Instant>& instants, std::optional<double> time) {
  if (!time || !instants.front().time) return instants.size() == 1 ? std::optional(Moment{}) : std::nullopt;
  const double slack = same_time * std::max(std::abs(*time), std::abs(*instants.back().time));
  for (std::size_t k = 0; k < instants.size(); ++k) {
    if (!instants[k].time) return std::nullopt;
    if (std::abs(*instants[k].time - *time) <= slack) return Moment{k, k, 0};
    if (k > 0 && *instants[k - 1].time < *time && *time < *instants[k].time)
      return Moment{k - 1, k, (*time - *instants[k - 1].time) / (*instants[k].time - *instants[k - 1].time)};
  }
  return std::nullopt;
}

template <int d>
Difference difference(const ForeignField<d>& a, Frames<d>& frames, const Moment& moment,
                      std::optional<double> time) {
  const ForeignField<d> first = frames.at(moment.before);  // a copy: reading the second may let go of it
  const ForeignField<d>& second = frames.at(moment.after);
  Difference out;
  out.time = time;
  out.between = moment.before != moment.after;
  out.same_points = same_points<d>(a.X, first.X);
  const bool velocities = !a.velocity.empty() && !first.velocity.empty() && !second.velocity.empty();
  const LinearFit<d> fit(first.X);
  double velocity = 0;
  for (std::size_t k = 0; k < a.X.size(); ++k) {
    std::vector<std::pair<std::size_t, double>> weights{{k, 1.0}};
    if (!out.same_points) weights = fit.weights(a.X[k]);
    if (weights.empty()) continue;
    Vec<d> u = Vec<d>::Zero(), v = Vec<d>::Zero();
    for (const auto& [j, weight] : weights) {
      u += weight * ((1 - moment.share) * first.displacement[j] + moment.share * second.displacement[j]);
      if (velocities)
        v += weight * ((1 - moment.share) * first.velocity[j] + moment.share * second.velocity[j]);
    }
    const double V = a.volume.empty() ? 1.0 / static_cast<double>(a.X.size()) : a.volume[k];
    const double error = (u - a.displacement[k]).squaredNorm();
    out.l2 += V * error;
    out.linf = std::max(out.linf, std::sqrt(error));
    out.size += V * a.displacement[k].squaredNorm();
    if (velocities) velocity += V * (v - a.velocity[k]).squaredNorm();
    ++out.points;
  }
  out.l2 = std::sqrt(out.l2);
  out.size = std::sqrt(out.size);
  if (velocities) out.velocity_l2 = std::sqrt(velocity);
  return out;
}

template <int d>
std::vector<Difference> compare_in(const std::vector<Instant>& a, const std::vector<Instant>& b,
                                   const PointOptions& options) {
  Frames<d> of_a(a, options), of_b(b, options);
  std::vector<Difference> all;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (const auto moment = moment_of(b, a[k].time))
      all.push_back(difference<d>(of_a.at(k), of_b, *moment, a[k].time));
  return all;
}

}  // namespace

std::vector<Instant> instants_of(const std::string& place) {
  if (!fs::exists(place))
    throw InputError(place + " is not there", "a folder of a run or one file is compared", "");
  if (!fs::is_directory(place)) {
    if (place.ends_with(".pvd")) return instants_of_index(place);
    return {{place, read_points(place).time}};
  }
  std::vector<fs::path> frames, indices;
  for (const auto& entry : fs::directory_iterator(place)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".pvd") indices.push_back(entry.path());
    if (ending == ".vtp" || ending == ".vtu") frames.push_back(entry.path());
  }
  if (indices.size() == 1) return instants_of_index(indices.front());
  std::sort(frames.begin(), frames.end());
  std::vector<Instant> instants;
  for (const fs::path& frame : frames) instants.push_back({frame.string(), read_points(frame.string()).time});
  if (instants.empty())
    throw InputError(place + " holds no frames", "there is no .pvd, .vtp or .vtu file in it", "");
  return instants;
}

std::vector<Difference> compare_runs(const std::string& a, const std::string& b,
                                     const PointOptions& options) {
  const std::vector<Instant> of_a = instants_of(a), of_b = instants_of(b);
  if (of_a.empty() || of_b.empty()) throw InputError((of_a.empty() ? a : b) + " holds no frames", "", "");
  const int dimension = dimension_of(read_points(of_a.front().file));
  if (dimension != dimension_of(read_points(of_b.front().file)))
    throw InputError("one run is in 2D and the other in 3D", "", "");
  std::vector<Difference> all =
      plumb::with_dimension(dimension, [&]<int d>() { return compare_in<d>(of_a, of_b, options); });
  if (all.empty())
    throw InputError("the runs have no time in common",
                     "times of the first are looked for among those of the second", "");
  return all;
}

}  // namespace plumb::app
