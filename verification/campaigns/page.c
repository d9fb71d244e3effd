/* A program of one page in C: second differences of a standing wave against its acceleration, order 2. Ends with 0 if it passes. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "plumbline.h"

enum { levels = 5, points = 200 };

static void must(plumb_status status) {
  if (status == PLUMB_OK) return;
  fprintf(stderr, "%s\n", plumb_message());
  exit((int)status);
}

/* Root mean square error of (u(t + h) - 2 u(t) + u(t - h))/h^2 against u_tt. */
static double error_of(const plumb_solution* wave, double h, double t) {
  static double X[2 * points], before[2 * points], now[2 * points], after[2 * points];
  plumb_norms norms;
  for (int k = 0; k < points; ++k) X[2 * k] = (k + 0.5) / points, X[2 * k + 1] = 0.5;
  must(plumb_evaluate(wave, PLUMB_DISPLACEMENT, points, X, t - h, before));
  must(plumb_evaluate(wave, PLUMB_DISPLACEMENT, points, X, t, now));
  must(plumb_evaluate(wave, PLUMB_DISPLACEMENT, points, X, t + h, after));
  for (int k = 0; k < 2 * points; ++k) now[k] = (after[k] - 2 * now[k] + before[k]) / (h * h);
  must(plumb_error(wave, PLUMB_ACCELERATION, points, X, t, now, NULL, &norms));
  return norms.relative_l2;
}

int main(void) {
  plumb_solution* wave;
  plumb_fit fit;
  double period, h[levels], error[levels];
  const double declared = 2;
  if (plumb_interface() != PLUMB_INTERFACE) return 1;
  must(plumb_new("standing-wave", 2, &wave));
  must(plumb_set(wave, "amplitude", 0.02));
  must(plumb_set_law(wave, "saint-venant-kirchhoff", 1e6, 0.3, 1000));
  must(plumb_period(wave, &period));
  for (int k = 0; k < levels; ++k) {
    h[k] = period / (20 << k);
    error[k] = error_of(wave, h[k], 0.3 * period);
    printf("h = %.4g s, relative error %.4g\n", h[k], error[k]);
  }
  must(plumb_fit_order(levels, h, error, 0, &declared, &fit, NULL));
  printf("plumbline %s: order %.4f [%.4f, %.4f], %s\n", plumb_version(), fit.order, fit.lower, fit.upper, fit.verdict);
  if (plumb_set(wave, "amplitud", 1) != PLUMB_BAD_INPUT) return 1;
  printf("refused: %s\n", plumb_message());
  plumb_free(wave);
  return fit.verdict[0] == 'p' && fabs(fit.order - declared) < 0.05 ? 0 : 1; /* the next term of the series is h^4 */
}
