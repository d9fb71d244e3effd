// The page that `plumb oned` makes: opened in a browser, its numbers are those of the commands, to 12 digits.
#include <gtest/gtest.h>

#include "tests/support/browser.hpp"

namespace plumb {
namespace {

using nlohmann::json;
using test::Browser;
using test::run_plumb;

std::string page() {
  const test::TemporaryFolder folder;
  const auto outcome = run_plumb("oned --page " + (folder / "page.html").string());
  EXPECT_EQ(outcome.code, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("28.7 % of its weights"), std::string::npos) << outcome.out;
  return test::content_of(folder / "page.html");
}

/// Chooses, and returns what is shown.
constexpr const char* script = R"js(
const choose = (id, value) => { const e = document.getElementById(id); e.value = value; e.dispatchEvent(new Event('input', {bubbles: true})); };
seen.states = [];
for (const [kernel, radius, jitter, place] of [['cubic', 5, '0', 0], ['cubic', 0, '0', 1], ['quintic', 4, '0.1', 20], ['wendland-c2', 6, '0.3', 40]]) {
  choose('kernel', kernel); choose('radius', radius); choose('jitter', jitter); choose('place', place);
  const state = {command: document.getElementById('command').textContent};
  for (const b of document.querySelectorAll('#numbers b')) state[b.dataset.name] = Number(b.dataset.value);
  state.lines = document.querySelectorAll('svg polyline').length;
  seen.states.push(state);
}
seen.overflow = document.documentElement.scrollWidth - document.documentElement.clientWidth;
)js";

TEST(ExplorerPage, ShowsWhatTheCommandsSay) {
  if (!Browser::installed()) FAIL() << "chromium or pdftotext is not installed: both are in .ci/packages.txt";
  const std::string text = page();
  for (const int width : {400, 1400}) {
    const json seen = Browser().open(text, width, script);
    EXPECT_EQ(seen["console"], "");
    EXPECT_LE(seen.value("overflow", 1), 0) << "the page is wider than the window";
    ASSERT_EQ(seen["states"].size(), 4u);
    for (const json& state : seen["states"]) {
      std::string command = state["command"].get<std::string>().substr(6);  // without "plumb "
      EXPECT_EQ(state["lines"], 3 + 4 + 2 + 2);
      const json kernels = json::parse(run_plumb(command + " --json -").out);
      const std::string words = "oned kernels";
      command.replace(command.find(words), words.size(), "oned correction");
      const json row = json::parse(run_plumb(command + " --json -").out)["rows"][0];
      const auto expect = [&](const char* shown, double right) {
        EXPECT_NEAR(state[shown].get<double>(), right, 1e-12 * (1 + std::abs(right)))
            << shown << ": " << command;
      };
      expect("alpha", kernels["alpha"].get<double>());
      expect("beta [1/m]", kernels["beta"].get<double>());
      expect("sum V W", kernels["sums"]["VW"].get<double>());
      expect("condition", row["condition"].get<double>());
      expect("negative share", row["negative"].get<double>());
    }
  }
}

}  // namespace
}  // namespace plumb
