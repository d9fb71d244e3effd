! Manufactured solutions and verdicts for Fortran: a module over libplumbline_c. Compile it with your program and link plumbline_c.
! Everything is documented in plumbline.h. Points are columns: X(dimension, points). A tensor is stored row by row, so that
! values(:, k) = [F_11, F_12, F_21, F_22] in 2D. A status other than plumb_ok is explained by plumb_message().
module plumbline
  use, intrinsic :: iso_c_binding
  implicit none
  private
  public :: plumb_new, plumb_free, plumb_set, plumb_set_law, plumb_set_law_parameter, plumb_set_plane_stress
  public :: plumb_evaluate, plumb_traction, plumb_error, plumb_fit_order, plumb_message, plumb_version, plumb_period

  integer(c_int), parameter, public :: plumb_ok = 0, plumb_failed = 1, plumb_bad_input = 2
  integer(c_int), parameter, public :: plumb_displacement = 0, plumb_velocity = 1, plumb_acceleration = 2, plumb_f = 3, &
    plumb_p = 4, plumb_cauchy = 5, plumb_body_force = 6, plumb_body_force_per_mass = 7, plumb_static_load = 8

  type, bind(c), public :: plumb_norms
    real(c_double) :: l2, linf, exact_l2, relative_l2
    integer(c_size_t) :: worst !< counts from 0
  end type
  type, public :: plumb_fit
    real(c_double) :: order, lower, upper, constant, drift
    integer(c_size_t) :: levels
    character(:), allocatable :: verdict
  end type
  type, bind(c) :: c_fit
    real(c_double) :: order, lower, upper, constant, drift
    integer(c_size_t) :: levels
    type(c_ptr) :: verdict
  end type

  interface
    integer(c_int) function c_new(name, dimension, solution) bind(c, name="plumb_new")
      import :: c_int, c_char, c_ptr
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int), value :: dimension
      type(c_ptr), intent(out) :: solution
    end function
    subroutine plumb_free(solution) bind(c, name="plumb_free")
      import :: c_ptr
      type(c_ptr), value :: solution
    end subroutine
    integer(c_int) function c_set(solution, parameter, value) bind(c, name="plumb_set")
      import :: c_int, c_char, c_ptr, c_double
      type(c_ptr), value :: solution
      character(kind=c_char), intent(in) :: parameter(*)
      real(c_double), value :: value
    end function
    integer(c_int) function c_set_law(solution, law, young, poisson, density) bind(c, name="plumb_set_law")
      import :: c_int, c_char, c_ptr, c_double
      type(c_ptr), value :: solution
      character(kind=c_char), intent(in) :: law(*)
      real(c_double), value :: young, poisson, density
    end function
    integer(c_int) function c_set_law_parameter(solution, parameter, value) bind(c, name="plumb_set_law_parameter")
      import :: c_int, c_char, c_ptr, c_double
      type(c_ptr), value :: solution
      character(kind=c_char), intent(in) :: parameter(*)
      real(c_double), value :: value
    end function
    integer(c_int) function plumb_set_plane_stress(solution, yes) bind(c, name="plumb_set_plane_stress")
      import :: c_int, c_ptr
      type(c_ptr), value :: solution
      integer(c_int), value :: yes
    end function
    integer(c_int) function plumb_period(solution, seconds) bind(c, name="plumb_period")
      import :: c_int, c_ptr, c_double
      type(c_ptr), value :: solution
      real(c_double), intent(out) :: seconds
    end function
    integer(c_int) function c_evaluate(solution, quantity, points, X, time, values) bind(c, name="plumb_evaluate")
      import :: c_int, c_ptr, c_size_t, c_double
      type(c_ptr), value :: solution
      integer(c_int), value :: quantity
      integer(c_size_t), value :: points
      real(c_double), intent(in) :: X(*)
      real(c_double), value :: time
      real(c_double), intent(out) :: values(*)
    end function
    integer(c_int) function c_traction(solution, points, X, N, time, values) bind(c, name="plumb_traction")
      import :: c_int, c_ptr, c_size_t, c_double
      type(c_ptr), value :: solution
      integer(c_size_t), value :: points
      real(c_double), intent(in) :: X(*), N(*)
      real(c_double), value :: time
      real(c_double), intent(out) :: values(*)
    end function
    integer(c_int) function c_error(solution, quantity, points, X, time, values, weights, norms) bind(c, name="plumb_error")
      import :: c_int, c_ptr, c_size_t, c_double, plumb_norms
      type(c_ptr), value :: solution
      integer(c_int), value :: quantity
      integer(c_size_t), value :: points
      real(c_double), intent(in) :: X(*), values(*), weights(*)
      real(c_double), value :: time
      type(plumb_norms), intent(out) :: norms
    end function
    integer(c_int) function c_fit_order(levels, spacings, errors, round_off, declared, fit, pairwise) &
      bind(c, name="plumb_fit_order")
      import :: c_int, c_ptr, c_size_t, c_double, c_fit
      integer(c_size_t), value :: levels
      real(c_double), intent(in) :: spacings(*), errors(*)
      real(c_double), value :: round_off
      real(c_double), intent(in), optional :: declared
      type(c_fit), intent(out) :: fit
      type(c_ptr), value :: pairwise
    end function
    type(c_ptr) function c_message() bind(c, name="plumb_message")
      import :: c_ptr
    end function
    type(c_ptr) function c_version() bind(c, name="plumb_version")
      import :: c_ptr
    end function
    integer(c_size_t) function c_strlen(text) bind(c, name="strlen")
      import :: c_size_t, c_ptr
      type(c_ptr), value :: text
    end function
  end interface

contains

  function text_of(pointer) result(text)
    type(c_ptr), intent(in) :: pointer
    character(:), allocatable :: text
    character(kind=c_char), pointer :: letters(:)
    integer :: k
    call c_f_pointer(pointer, letters, [c_strlen(pointer)])
    allocate (character(size(letters)) :: text)
    do k = 1, size(letters)
      text(k:k) = letters(k)
    end do
  end function

  !> What was wrong with the last call that failed, and what to do.
  function plumb_message() result(text)
    character(:), allocatable :: text
    text = text_of(c_message())
  end function

  function plumb_version() result(text)
    character(:), allocatable :: text
    text = text_of(c_version())
  end function

  integer(c_int) function plumb_new(name, dimension, solution) result(status)
    character(*), intent(in) :: name
    integer, intent(in) :: dimension
    type(c_ptr), intent(out) :: solution
    solution = c_null_ptr
    status = c_new(trim(name)//c_null_char, int(dimension, c_int), solution)
  end function

  integer(c_int) function plumb_set(solution, parameter, value) result(status)
    type(c_ptr), intent(in) :: solution
    character(*), intent(in) :: parameter
    real(c_double), intent(in) :: value
    status = c_set(solution, trim(parameter)//c_null_char, value)
  end function

  integer(c_int) function plumb_set_law(solution, law, young, poisson, density) result(status)
    type(c_ptr), intent(in) :: solution
    character(*), intent(in) :: law
    real(c_double), intent(in) :: young, poisson, density
    status = c_set_law(solution, trim(law)//c_null_char, young, poisson, density)
  end function

  integer(c_int) function plumb_set_law_parameter(solution, parameter, value) result(status)
    type(c_ptr), intent(in) :: solution
    character(*), intent(in) :: parameter
    real(c_double), intent(in) :: value
    status = c_set_law_parameter(solution, trim(parameter)//c_null_char, value)
  end function

  !> values(components, points): as many columns as X has.
  integer(c_int) function plumb_evaluate(solution, quantity, X, time, values) result(status)
    type(c_ptr), intent(in) :: solution
    integer(c_int), intent(in) :: quantity
    real(c_double), intent(in), contiguous :: X(:, :)
    real(c_double), intent(in) :: time
    real(c_double), intent(out), contiguous :: values(:, :)
    status = c_evaluate(solution, quantity, size(X, 2, c_size_t), X, time, values)
  end function

  integer(c_int) function plumb_traction(solution, X, N, time, values) result(status)
    type(c_ptr), intent(in) :: solution
    real(c_double), intent(in), contiguous :: X(:, :), N(:, :)
    real(c_double), intent(in) :: time
    real(c_double), intent(out), contiguous :: values(:, :)
    status = c_traction(solution, size(X, 2, c_size_t), X, N, time, values)
  end function

  !> Norms of values(components, points) against the solution, with a volume for each point.
  integer(c_int) function plumb_error(solution, quantity, X, time, values, weights, norms) result(status)
    type(c_ptr), intent(in) :: solution
    integer(c_int), intent(in) :: quantity
    real(c_double), intent(in), contiguous :: X(:, :), values(:, :), weights(:)
    real(c_double), intent(in) :: time
    type(plumb_norms), intent(out) :: norms
    status = c_error(solution, quantity, size(X, 2, c_size_t), X, time, values, weights, norms)
  end function

  !> Order of the errors over the spacings, judged against `declared` if it is there.
  integer(c_int) function plumb_fit_order(spacings, errors, fit, declared) result(status)
    real(c_double), intent(in), contiguous :: spacings(:), errors(:)
    type(plumb_fit), intent(out) :: fit
    real(c_double), intent(in), optional :: declared
    type(c_fit) :: found
    status = c_fit_order(size(spacings, kind=c_size_t), spacings, errors, 0.0_c_double, declared, found, c_null_ptr)
    if (status /= plumb_ok) return
    fit%order = found%order
    fit%lower = found%lower
    fit%upper = found%upper
    fit%constant = found%constant
    fit%drift = found%drift
    fit%levels = found%levels
    fit%verdict = text_of(found%verdict)
  end function

end module plumbline
