#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

class Section;
template <int d>
struct BondOptions;
template <int d>
struct PartSite;

/// Chooses the Jameson-Schmidt-Turkel dissipation of the momentum p = rho v (28):
/// D = eta2 C h lap' p - eta4 C h^3 lap' (lap p), lap the corrected Laplacian (27). THEORY (6.1)-(6.4). It is
/// the section [jst] of a scene or study; without the section nothing of it is built.
struct JstOptions {
  static constexpr std::string_view section = "jst", subject = "dissipation", theory = "THEORY (6.1), (6.4)";
  static constexpr std::string_view meaning = "Jameson-Schmidt-Turkel dissipation of the momentum";

  double eta2 = 0.0;         ///< second-order coefficient; 0: that term is not built
  double eta4 = 1.0 / 64.0;  ///< fourth-order coefficient, the paper's for the columns
  double laplacian_factor =
      2.0;  ///< of phi = -factor W'/r; the paper's own Laplacian is probably half of it: 1
  std::string outer = "symmetric";  ///< symmetric (28) | transpose: L^T V L, dissipative by construction

  /// Reads the section. Throws SceneError.
  static std::optional<JstOptions> read(const Section& section);
  /// Says for a reader what it is set to.
  std::string in_words() const;
  /// Asks for the weights of the Laplacian.
  template <int d>
  void ask_for_weights(BondOptions<d>& bonds) const;
  /// Adds the term and its limit of the time step.
  template <int d>
  void add_to(PartSite<d>& site) const;
};

/// Lists the names of the outer level of (28).
std::vector<std::string> outer_laplacian_names();

}  // namespace plumb
