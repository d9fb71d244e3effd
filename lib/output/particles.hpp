#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace plumb {

/// Values of one quantity on all particles, `components` numbers each, particle after particle. A vector of a
/// plane problem (2 components) is written with z = 0; one of a line would be taken for a scalar, so it comes padded.
struct PointField {
  std::string name;  ///< with its unit: "velocity [m/s]"
  int components = 1;
  std::span<const double> values;
};

/// Particles at one time. Nothing here knows the solver or its dimension.
struct ParticleFrame {
  double time = 0;                    ///< [s]
  int dimension = 3;                  ///< numbers per position: 1, 2 or 3; missing ones are written as 0
  std::span<const double> positions;  ///< current positions [m], particle after particle
  std::span<const PointField> fields;
};

/// Vectors of `components` numbers as vectors of three, the rest zero.
std::vector<double> padded_to_three(std::span<const double> values, int components);

/// The frame as a VTK XML PolyData file (.vtp): one vertex a particle, the fields as point data, an "id"
/// array that counts from 0, the time as field data "TimeValue". Arrays are base64, so that no digit is lost.
/// std::invalid_argument if a field's size does not fit.
std::string vtp_text(const ParticleFrame& frame);

/// A time series of particles for ParaView: FOLDER/NAME_000000.vtp, .. and FOLDER/NAME.pvd, which lists them
/// with their times. Every file is replaced as a whole; the .pvd names only files that are complete. When
/// they reach the disk is left to the system until flush() or finish().
class ParticleSeries {
 public:
  ParticleSeries(std::filesystem::path folder, std::string name)
      : folder_(std::move(folder)), name_(std::move(name)) {}

  /// Writes the next file of the series. Throws OutputError; what was written before stays readable.
  void write(const ParticleFrame& frame);

  /// Puts every file on the disk that has been written since the last call. Throws OutputError.
  void flush();
  /// Puts the index and the last file on the disk. Throws OutputError.
  void finish();

  /// Continues a series that another run left with these times; later files of it are removed.
  /// InputError if one of them is not there or empty.
  void resume(std::vector<double> times);
  /// Removes the index and every file of a series of that name in the folder.
  void clear();
  const std::vector<double>& times() const { return times_; }

  std::filesystem::path index_file() const { return folder_ / (name_ + ".pvd"); }
  std::size_t size() const { return times_.size(); }

 private:
  std::string file_name(std::size_t number) const;
  void remove_from(std::size_t number) const;
  void write_index() const;

  std::filesystem::path folder_;
  std::string name_;
  std::vector<double> times_;
  std::size_t flushed_ = 0;  ///< files that are on the disk for sure
};

}  // namespace plumb
