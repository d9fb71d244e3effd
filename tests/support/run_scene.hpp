#pragma once
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/program.hpp"

namespace plumb::test {

/// A scene in a folder of its own, and what its runs leave there.
class SceneFolder {
 public:
  explicit SceneFolder(const std::string& scene) { std::ofstream(folder_ / "scene.toml") << scene; }

  /// The shell command that runs it into folder `out`.
  std::string call(const std::string& out, const std::string& arguments = "") const {
    return PLUMB_EXECUTABLE " run " + (folder_ / "scene.toml").string() + " --out " +
           (folder_ / out).string() + " " + arguments;
  }
  Outcome run(const std::string& out, const std::string& arguments = "") const {
    return run_shell(call(out, arguments));
  }
  std::filesystem::path file(const std::string& out, const std::string& name) const {
    return folder_ / out / name;
  }
  nlohmann::json summary(const std::string& out) const {
    return nlohmann::json::parse(content_of(file(out, "summary.json")));
  }
  /// Columns of a CSV file by name.
  std::map<std::string, std::vector<double>> columns(const std::string& out, const std::string& name) const {
    std::istringstream lines(content_of(file(out, name)));
    std::string line, cell;
    std::getline(lines, line);
    std::vector<std::string> names;
    for (std::istringstream heading(line); std::getline(heading, cell, ',');) names.push_back(cell);
    std::map<std::string, std::vector<double>> all;
    while (std::getline(lines, line)) {
      std::istringstream cells(line);
      for (const auto& column : names) {
        std::getline(cells, cell, ',');
        all[column].push_back(std::stod(cell));
      }
    }
    return all;
  }
  /// What VTK's own reader finds in the particle files.
  nlohmann::json frames(const std::string& out) const {
    const auto read = run_shell("/usr/bin/python3 " PLUMBLINE_SOURCE_DIR "/tests/lib/output/read_back.py " +
                                file(out, "particles.pvd").string());
    return nlohmann::json::parse(read.out);
  }
  const std::filesystem::path& path() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

}  // namespace plumb::test
