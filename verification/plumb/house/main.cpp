#include "verification/plumb/house_commands.hpp"
#include "verification/plumb/program.hpp"

int main(int count, char** arguments) {
  return plumb::app::run_program(
      {"plumb-house", "Plumbline's house: its claims, its planted faults, its refusals and its speed",
       &plumb::app::add_all_house_commands},
      count, arguments);
}
