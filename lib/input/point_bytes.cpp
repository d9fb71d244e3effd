#include "lib/input/point_bytes.hpp"

#include <cstring>

namespace plumb {
namespace {

class Writer {
 public:
  void number(std::size_t value) { raw(&value, sizeof value); }
  void text(const std::string& value) {
    number(value.size());
    bytes += value;
  }
  void numbers(const std::vector<double>& values) {
    number(values.size());
    raw(values.data(), values.size() * sizeof(double));
  }
  std::string bytes;

 private:
  void raw(const void* from, std::size_t size) { bytes.append(static_cast<const char*>(from), size); }
};

/// Reads what Writer wrote: another process of this program, so that nothing is checked.
class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}
  std::size_t number() {
    std::size_t value = 0;
    raw(&value, sizeof value);
    return value;
  }
  std::string text() {
    std::string value(number(), ' ');
    raw(value.data(), value.size());
    return value;
  }
  std::vector<double> numbers() {
    std::vector<double> values(number());
    raw(values.data(), values.size() * sizeof(double));
    return values;
  }

 private:
  void raw(void* to, std::size_t size) {
    if (size > 0) std::memcpy(to, bytes_.data() + at_, size);
    at_ += size;
  }
  const std::string& bytes_;
  std::size_t at_ = 0;
};

}  // namespace

std::string bytes_of(const PointFile& file) {
  Writer out;
  out.number(1);
  out.number(file.count);
  out.numbers(file.positions);
  out.numbers(file.time ? std::vector<double>{*file.time} : std::vector<double>{});
  out.number(file.columns.size());
  for (const PointColumn& column : file.columns) {
    out.text(column.name);
    out.number(static_cast<std::size_t>(column.components));
    out.numbers(column.values);
  }
  return out.bytes;
}

std::string bytes_of(const InputError& error) {
  Writer out;
  out.number(0);
  for (const std::string* part : {&error.problem(), &error.why(), &error.suggestion()}) out.text(*part);
  return out.bytes;
}

PointFile points_of(const std::string& bytes) {
  Reader in(bytes);
  if (in.number() == 0) {
    const std::string problem = in.text(), why = in.text(), suggestion = in.text();
    throw InputError(problem, why, suggestion);
  }
  PointFile file;
  file.count = in.number();
  file.positions = in.numbers();
  if (const auto time = in.numbers(); !time.empty()) file.time = time.front();
  file.columns.resize(in.number());
  for (PointColumn& column : file.columns) {
    column.name = in.text();
    column.components = static_cast<int>(in.number());
    column.values = in.numbers();
  }
  return file;
}

}  // namespace plumb
