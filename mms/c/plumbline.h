/* Manufactured solutions of solid mechanics, and verdicts on orders of convergence, for programs in any language (C99).
 *
 * Every function that can fail returns a plumb_status. After PLUMB_BAD_INPUT or PLUMB_FAILED, plumb_message() says what was wrong
 * and what to do, and nothing has been written to the results. No exception leaves the library. All units are SI.
 * Points are stored one after the other, X[point * dimension + axis]; tensors row by row, F[i * dimension + A] = dx_i/dX_A.
 * One solution may be evaluated from several threads at a time; it must not be changed meanwhile. */
#ifndef PLUMBLINE_H
#define PLUMBLINE_H
#include <stddef.h>

#if defined(__GNUC__)
#define PLUMB_API __attribute__((visibility("default")))
#else
#define PLUMB_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* The interface that this header describes. It counts up when something is taken away or changes its meaning; then the name of
 * the shared library changes too. */
#define PLUMB_INTERFACE 1
PLUMB_API int plumb_interface(void);         /* the interface of the library that was found */
PLUMB_API const char* plumb_version(void);   /* "0.1.0" */

typedef enum plumb_status {
  PLUMB_OK = 0,
  PLUMB_FAILED = 1,    /* out of memory, or a fault of the library */
  PLUMB_BAD_INPUT = 2  /* what was given cannot be used */
} plumb_status;

/* The last message of this thread: "problem. Why. Suggestion."; "" if there was none. Good until the next call that fails. */
PLUMB_API const char* plumb_message(void);

/* ---- The catalogue ------------------------------------------------------------------------------------------------------ */

typedef struct plumb_parameter {
  const char* name;
  const char* unit;     /* "m", "rad"; "" for pure numbers */
  const char* meaning;
  double value;         /* default; NaN: it has none and must be given */
  double least, most;   /* allowed range, ends included; may be infinite */
} plumb_parameter;

PLUMB_API size_t plumb_solution_count(void);
PLUMB_API const char* plumb_solution_name(size_t solution);     /* NULL beyond the last one */
PLUMB_API const char* plumb_solution_summary(size_t solution);
PLUMB_API int plumb_solution_exists_in(size_t solution, int dimension);
PLUMB_API size_t plumb_solution_parameter_count(size_t solution);
PLUMB_API plumb_status plumb_solution_parameter(size_t solution, size_t k, plumb_parameter* parameter);

PLUMB_API size_t plumb_law_count(void);
PLUMB_API const char* plumb_law_name(size_t law);               /* NULL beyond the last one */
PLUMB_API int plumb_law_has_history(size_t law);
PLUMB_API size_t plumb_law_parameter_count(size_t law);
PLUMB_API plumb_status plumb_law_parameter(size_t law, size_t k, plumb_parameter* parameter);

/* ---- One solution ------------------------------------------------------------------------------------------------------- */

typedef struct plumb_solution plumb_solution;

/* Makes a solution by name in 1, 2 or 3 dimensions, with its default parameters, its own elastic constants and the law
 * "neo-hookean". Free it with plumb_free(). */
PLUMB_API plumb_status plumb_new(const char* name, int dimension, plumb_solution** solution);
PLUMB_API void plumb_free(plumb_solution* solution); /* NULL is allowed */

/* Sets a parameter of the solution. A value out of its range is refused. */
PLUMB_API plumb_status plumb_set(plumb_solution* solution, const char* parameter, double value);
/* Chooses the law with Young's modulus [Pa], Poisson's ratio and the reference density [kg/m^3]; the law's own parameters go
 * back to their defaults. */
PLUMB_API plumb_status plumb_set_law(plumb_solution* solution, const char* law, double young, double poisson, double density);
PLUMB_API plumb_status plumb_set_law_parameter(plumb_solution* solution, const char* parameter, double value);
/* 2D: 1 for plane stress, 0 for plane strain (the default). */
PLUMB_API plumb_status plumb_set_plane_stress(plumb_solution* solution, int yes);
/* Laws with history: number of equal steps from time 0 to the time asked for (100). */
PLUMB_API plumb_status plumb_set_increments(plumb_solution* solution, int increments);

PLUMB_API int plumb_dimension(const plumb_solution* solution);
PLUMB_API plumb_status plumb_period(const plumb_solution* solution, double* seconds); /* characteristic time [s] */
/* The box around the domain [m]: `dimension` numbers each. */
PLUMB_API plumb_status plumb_box(const plumb_solution* solution, double* origin, double* size);
/* 1 for points of the domain, else 0 (the vortex lives on an annulus within its box). */
PLUMB_API plumb_status plumb_contains(const plumb_solution* solution, size_t points, const double* X, int* inside);

typedef enum plumb_quantity {
  PLUMB_DISPLACEMENT = 0,        /* u [m] */
  PLUMB_VELOCITY = 1,            /* u_t [m/s] */
  PLUMB_ACCELERATION = 2,        /* u_tt [m/s^2] */
  PLUMB_F = 3,                   /* deformation gradient */
  PLUMB_P = 4,                   /* first Piola-Kirchhoff stress [Pa]; the stress of linear elasticity */
  PLUMB_CAUCHY = 5,              /* P F^T/J [Pa] */
  PLUMB_BODY_FORCE = 6,          /* rho u_tt - Div P per reference volume [N/m^3]: the load that makes u the solution */
  PLUMB_BODY_FORCE_PER_MASS = 7, /* the same over rho [N/kg] */
  PLUMB_STATIC_LOAD = 8          /* -Div P per reference volume [N/m^3]: the load of the equilibrium at that time */
} plumb_quantity;

/* Numbers of one point: `dimension` for vectors, its square for tensors; 0 for what is no quantity. */
PLUMB_API size_t plumb_components(const plumb_solution* solution, plumb_quantity quantity);
/* Evaluates a quantity at reference positions X [m] and one time [s]. `values` has room for points * plumb_components(). */
PLUMB_API plumb_status plumb_evaluate(const plumb_solution* solution, plumb_quantity quantity, size_t points, const double* X,
                                      double time, double* values);
/* Traction P N per reference area [Pa], for outward unit normals N of the reference configuration. */
PLUMB_API plumb_status plumb_traction(const plumb_solution* solution, size_t points, const double* X, const double* N, double time,
                                      double* values);

/* ---- Norms -------------------------------------------------------------------------------------------------------------- */

typedef struct plumb_norms {
  double l2;          /* square root of sum weight |error|^2 [unit * m^(d/2) with volumes as weights] */
  double linf;        /* largest |error| of a point; Frobenius for tensors */
  double exact_l2;    /* l2 of the exact field by the same weights */
  double relative_l2; /* l2/exact_l2; NaN where the exact field is zero */
  size_t worst;       /* the point of linf */
} plumb_norms;

/* Compares values with the solution. `weights` are volumes [m^d]; NULL gives each point 1/points, so that l2 is a root mean
 * square. Values that are not finite are refused. */
PLUMB_API plumb_status plumb_error(const plumb_solution* solution, plumb_quantity quantity, size_t points, const double* X,
                                   double time, const double* values, const double* weights, plumb_norms* norms);
/* The same for any two fields of `components` numbers a point; exact = NULL stands for zero. */
PLUMB_API plumb_status plumb_field_error(size_t points, size_t components, const double* values, const double* exact,
                                         const double* weights, plumb_norms* norms);

/* ---- Orders and verdicts ------------------------------------------------------------------------------------------------ */

typedef struct plumb_fit {
  double order;        /* p of error = C h^p; NaN: not determined, the verdict says why */
  double lower, upper; /* 95 % interval of p; NaN for fewer than three levels */
  double constant;     /* C [unit of the error / m^p] */
  double drift;        /* change of the local slope over the levels; NaN for fewer than three */
  size_t levels;       /* that were fitted */
  const char* verdict; /* "pass", "fail", "above", .. if an order was declared, else "asymptotic", "stalled", .. */
} plumb_fit;

/* Fits an order of convergence to the errors of `levels` spacings, in any sequence and with any ratios, and judges it against
 * `declared` (NULL: none). `round_off` is the size of the errors' own round-off, 0 if it is not known. `pairwise` is NULL or
 * has room for levels - 1 orders between neighbouring levels, from coarse to fine; NaN where there is none. */
PLUMB_API plumb_status plumb_fit_order(size_t levels, const double* spacings, const double* errors, double round_off,
                                       const double* declared, plumb_fit* fit, double* pairwise);

/* One or two sentences that explain a verdict; "" for an unknown word. */
PLUMB_API const char* plumb_meaning(const char* verdict);

typedef struct plumb_extrapolation {
  const char* behaviour;   /* "monotone", "oscillatory", "divergent", "converged"; numbers exist for the first only, else NaN */
  double order, limit;     /* observed order; value at spacing 0 */
  double asymptotic_ratio; /* 1 in the asymptotic range; NaN where it cannot fail (three grids, no declared order) */
} plumb_extrapolation;

/* Richardson extrapolation of values on three grids or more, where no exact one is known. `gci` and `gci_absolute` are NULL or
 * have room for grids - 1 grid convergence indices, finest pair first: relative to the finer value, and in its unit. `safety` is
 * 1.25 for Roache's factor. */
PLUMB_API plumb_status plumb_extrapolate(size_t grids, const double* spacings, const double* values, double safety,
                                         const double* declared, plumb_extrapolation* result, double* gci, double* gci_absolute);

typedef struct plumb_grid_fit {
  const char* expansion; /* "limit + a h^p", "limit + a h", "limit + a h^2", "limit + a h + b h^2" */
  int weighted;          /* 1: weights proportional to 1/h */
  double order;          /* p of the power law; NaN: none between 0.01 and 20 */
  double limit;          /* value at spacing 0 */
  double deviation, range, safety;
  double uncertainty;    /* of the finest grid */
} plumb_grid_fit;

/* The grid convergence index by least squares over four grids or more, for noisy values (Eca and Hoekstra 2014). `uncertainties`
 * is NULL or has room for one number a grid, fine to coarse. */
PLUMB_API plumb_status plumb_fit_grids(size_t grids, const double* spacings, const double* values, plumb_grid_fit* result,
                                       double* uncertainties);

#ifdef __cplusplus
}
#endif
#endif
