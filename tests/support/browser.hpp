#pragma once
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/program.hpp"

namespace plumb::test {

/// Headless Chromium, alone with its files.
class Browser {
 public:
  static bool installed() { return run_shell("command -v chromium && command -v pdftotext").code == 0; }

  /// Calls Chromium with more arguments; the last one is the file to open.
  Outcome call(const std::string& arguments) const {
    return run_shell(
        "timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
        "--disable-background-networking --disable-component-update --disable-sync --enable-logging=stderr "
        "--user-data-dir=" +
        (folder_ / "profile").string() + " " + arguments);
  }

  /// Opens `page` in a frame of that width (a window of Chromium is never narrower than 500 pixels), runs
  /// `script` in it, which fills the object `seen`, and returns that; what the console says is under
  /// "console".
  nlohmann::json open(const std::string& page, int width, const std::string& script) const {
    std::string whole = page;
    whole.insert(whole.rfind("</body>"), "<script>const seen = {};\n" + script +
                                             "\nparent.postMessage(JSON.stringify(seen), '*');</script>");
    std::ofstream(folder_ / "page.html") << whole;
    std::ofstream(folder_ / "frame.html")
        << "<title></title><script>onmessage = e => { document.title = e.data; };</script>"
           "<iframe src=\"page.html\" style=\"border:0;height:900px;width:"
        << width << "px\"></iframe>";
    const auto outcome = call("--window-size=1800,1000 --virtual-time-budget=5000 --dump-dom file://" +
                              (folder_ / "frame.html").string());
    const auto start = outcome.out.find("<title>") + 7;
    std::string text = outcome.out.substr(start, outcome.out.find("</title>") - start);
    for (const auto& [from, to] : {std::pair("&lt;", "<"), std::pair("&gt;", ">"), std::pair("&amp;", "&")})
      for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + 1))
        text.replace(at, std::string(from).size(), to);
    auto seen = nlohmann::json::parse(text, nullptr, false);
    if (!seen.is_object()) seen = nlohmann::json::object();
    const auto said = outcome.error.find("CONSOLE");
    seen["console"] = said == std::string::npos ? "" : outcome.error.substr(said, 400);
    return seen;
  }

  /// Prints `page` without running any script of it, and returns the text of the sheets, blanks left out;
  /// `outside` counts the words that do not lie on their sheet as a whole.
  std::string print(const std::string& page, int& words, int& outside) const {
    // Chromium prints by a script of its own, so it cannot be told to run none: the script is cut out.
    std::ofstream(folder_ / "page.html") << page.substr(0, page.rfind("<script>")) << "</body></html>";
    const std::string pdf = (folder_ / "page.pdf").string();
    call("--no-pdf-header-footer --print-to-pdf=" + pdf + " file://" + (folder_ / "page.html").string());
    const std::string boxes = run_shell("pdftotext -bbox " + pdf + " -").out;
    double sheet = 0;
    words = outside = 0;
    for (std::size_t at = 0; (at = boxes.find('<', at)) != std::string::npos; ++at) {
      if (boxes.compare(at, 6, "<page ") == 0) sheet = attribute(boxes, at, "width=\"");
      if (boxes.compare(at, 6, "<word ") != 0) continue;
      ++words;
      const double rounding = 0.5;  // of the outlines of letters [pt]
      if (attribute(boxes, at, "xMin=\"") < -rounding || attribute(boxes, at, "xMax=\"") > sheet + rounding)
        ++outside;
    }
    std::string text;
    for (const char c : run_shell("pdftotext -raw " + pdf + " -").out)
      if (c != ' ' && c != '\n' && c != '\f') text += c;
    return text;
  }

 private:
  static double attribute(const std::string& text, std::size_t from, const std::string& key) {
    const auto at = text.find(key, from);
    return at == std::string::npos ? 0 : std::strtod(text.c_str() + at + key.size(), nullptr);
  }

  TemporaryFolder folder_;
};

/// What a reader does with any page of the report: sizes, anchors, every table sorted, filtered, every slider
/// moved.
constexpr const char* reader = R"js(
const root = document.documentElement;
seen.frame = innerWidth;
seen.overflow = root.scrollWidth - root.clientWidth;
seen.lost = [...document.querySelectorAll('a[href^="#"]')].map(a => a.getAttribute('href'))
  .filter(h => !document.getElementById(decodeURIComponent(h.slice(1))));
const ids = [...document.querySelectorAll('[id]')].map(e => e.id);
seen.twice = ids.filter((id, k) => ids.indexOf(id) !== k);
seen.text = Math.min(...[...document.querySelectorAll('p.a, p.q, p.note')]
  .map(p => parseFloat(getComputedStyle(p).fontSize)));
seen.unsorted = []; seen.unfiltered = [];
for (const table of document.querySelectorAll('table.data')) {
  const rows = () => [...table.tBodies[0].rows];
  const name = table.closest('[id]').id;
  [...table.tHead.rows[0].cells].forEach((heading, column) => {
    const numbers = () => rows().map(r => r.cells[column]).filter(c => c && c.dataset.v).map(c => Number(c.dataset.v))
      .filter(v => !Number.isNaN(v));
    const button = heading.querySelector('button');
    button.click();
    const up = numbers();
    button.click();
    const down = numbers();
    if (up.some((v, k) => k > 0 && v < up[k - 1]) || down.some((v, k) => k > 0 && v > down[k - 1]) ||
        heading.getAttribute('aria-sort') !== 'descending') seen.unsorted.push(name + ' ' + column);
  });
  const filter = table.parentElement.previousElementSibling;
  if (!filter || !filter.matches('input.filter')) continue;
  const type = text => { filter.value = text; filter.dispatchEvent(new Event('input')); };
  const shown = () => rows().filter(r => !r.hidden);
  const word = rows()[0].textContent.toLowerCase().split(/\s+/).filter(Boolean)[0];
  type(word);
  if (!shown().length || shown().some(r => !r.textContent.toLowerCase().includes(word))) seen.unfiltered.push(name);
  type('no-row-has-this');
  if (shown().length) seen.unfiltered.push(name);
  type('');
  if (shown().length !== rows().length) seen.unfiltered.push(name);
}
seen.sliders = 0; seen.stuck = [];
for (const slider of document.querySelectorAll('.slider input')) {
  ++seen.sliders;
  const frames = [...slider.closest('figure').querySelectorAll('.frame')];
  for (const k of [0, frames.length - 1]) {
    slider.value = k; slider.dispatchEvent(new Event('input'));
    const on = frames.filter(f => getComputedStyle(f).display !== 'none');
    if (on.length !== 1 || on[0] !== frames[k]) seen.stuck.push(slider.closest('figure').id + ' ' + k);
  }
}
const squeeze = e => e.textContent.replace(/\s+/g, '');
seen.cells = [...document.querySelectorAll('table.data td:not(.see), .frame p, p.a')].map(squeeze);
)js";

}  // namespace plumb::test
