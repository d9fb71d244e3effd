#include "verification/plumb/commands.hpp"
#include "verification/plumb/hand_over.hpp"
#include "verification/plumb/program.hpp"

int main(int count, char** arguments) {
  return plumb::app::run_program(
      {"plumb", "Plumbline: total Lagrangian SPH for solids, checked against mathematics",
       &plumb::app::add_all_commands, &plumb::app::hand_over},
      count, arguments);
}
