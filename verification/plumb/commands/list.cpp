#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <ostream>

#include "plumb/commands.hpp"
#include "plumb/session.hpp"
#include "plumbline/gradient/catalogue.hpp"
#include "plumbline/kernel/catalogue.hpp"

namespace plumb {

/// `plumb list`: the parts that scenes and options can name.
void add_list(CLI::App& program, Session& session) {
  const auto action = [&session] {
    const nlohmann::ordered_json parts{{"kernels", names_of(KernelCatalogue{})},
                                       {"gradients", names_of(EstimatorCatalogue{})}};
    for (const auto& part : parts.items())
      for (const auto& name : part.value())
        session.text() << part.key() << ": " << name.get<std::string>() << '\n';
    session.write_json(parts);
    return 0;
  };
  add_command(program, session,
              {"list", "the kernels and gradients that can be named", "plumb list --json -"}, {}, action);
}

}  // namespace plumb
