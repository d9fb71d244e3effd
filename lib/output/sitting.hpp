#pragma once
#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>

#include "lib/output/listed.hpp"
#include "lib/output/result_store.hpp"

namespace plumb {

/// Thrown out of a study that was asked to end before it was whole.
class SittingEnded : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One sitting at a long study: from a call of the program to its end or its interruption. The parts that it finishes are kept by name; when it is
/// ended before the study is whole, or killed, the next one with the same content finds them and makes only
/// what is missing. A study that becomes whole leaves nothing behind. Safe to use from several threads.
class Sitting {
 public:
  using Json = nlohmann::ordered_json;
  /// Told the share of this sitting's work that is done, and a note: the part at hand and the rate.
  using Listener = std::function<void(double fraction, const std::string& note)>;

  /// Keeps nothing and is never ended.
  Sitting() = default;
  /// Keeps parts in one file of `folder`, which is made when there is something to keep. `content` holds all
  /// that decides the results: parts of other content are not taken. `go_on` is asked before every part.
  Sitting(const std::filesystem::path& folder, std::string content, std::function<bool()> go_on);

  /// From now on tells the listener how far it is: at the end of every part, and where a loop calls check().
  /// `whole` is the work of all parts; what earlier sittings made takes no time and does not count. `unit` is
  /// that of the rates that check() gets.
  void tell(double whole, Listener listener, std::string unit = "");
  /// The part of that name: of an earlier sitting, or made now. Throws SittingEnded if it would have to be
  /// made and the sitting is to end; its text says what was kept and where, or why it could not be.
  /// `work` is its share of what tell() was told.
  Json part(const std::string& name, const std::function<Json()>& make, double work = 1);
  /// Makes a part out of a value that lists its members (listed.hpp): a value made now is returned as it is.
  template <Listed T>
  T value(const std::string& name, const std::function<T()>& make, double work = 1) {
    std::optional<T> made;
    const Json found = part(
        name, [&] { return to_json(made.emplace(make())); }, work);
    return made ? std::move(*made) : from_json<T>(found);
  }
  /// For the loops inside a part: throws SittingEnded if the sitting is to end. `done` is the share of the
  /// part that is behind and `rate` how fast it goes, per second; they count where parts are made one at a
  /// time.
  void check(double done = 0, double rate = 0);
  /// Parts taken from earlier sittings so far.
  int recalled() const { return recalled_; }
  /// The study is whole: what was kept is removed.
  void close();

 private:
  /// Where the listener is told from: the part being made, and the work around it.
  struct Work {
    Listener listener;
    std::string unit, part;
    double whole = 0, made = 0, at_hand = 0;
    double done = 0, rate = 0;  ///< of the part at hand
    std::chrono::steady_clock::time_point said;
  };

  Json make_part(const std::string& name, const std::function<Json()>& make, double work);
  void say();
  void try_to_save();

  ResultStore store_;
  std::string content_;
  std::function<bool()> go_on_;
  std::map<std::string, std::string> parts_;  ///< as JSON text
  std::string problem_;                       ///< of the last attempt to save
  std::mutex mutex_;
  int recalled_ = 0;
  Work work_;
  std::chrono::steady_clock::time_point saved_ = std::chrono::steady_clock::now();
};

/// The number of a kept part; null, which JSON has for what is not finite, is NaN.
double number_or_nan(const Sitting::Json& value);

}  // namespace plumb
