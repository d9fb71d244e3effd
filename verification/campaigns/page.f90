! A program of one page in Fortran: P by the finite differences of an energy is not at hand, so F is found by differences of the
! displacement and judged against the solution's own, order 2. Ends with 0 if it passes.
program page
  use, intrinsic :: iso_c_binding
  use plumbline
  implicit none
  integer, parameter :: levels = 5, n = 50
  type(c_ptr) :: plate
  type(plumb_fit) :: fit
  type(plumb_norms) :: norms
  real(c_double) :: X(2, n), ahead(2, n), behind(2, n), F(4, n), weights(n), h(levels), error(levels), shift(2), period
  integer :: k, level, axis

  call must(plumb_new("swinging-plate", 2, plate))
  call must(plumb_set(plate, "amplitude", 0.05_c_double))
  call must(plumb_set_law(plate, "neo-hookean", 17e6_c_double, 0.45_c_double, 1100.0_c_double))
  call must(plumb_period(plate, period))
  do k = 1, n
    X(:, k) = [2.0_c_double*(k - 0.5_c_double)/n, 0.1_c_double + 1.7_c_double*k/n]
  end do
  weights = 4.0_c_double/n
  do level = 1, levels
    h(level) = 0.2_c_double/2**level
    do axis = 1, 2
      shift = 0
      shift(axis) = h(level)/2
      call must(plumb_evaluate(plate, plumb_displacement, X + spread(shift, 2, n), 0.3_c_double*period, ahead))
      call must(plumb_evaluate(plate, plumb_displacement, X - spread(shift, 2, n), 0.3_c_double*period, behind))
      F(axis, :) = (ahead(1, :) - behind(1, :))/h(level)
      F(2 + axis, :) = (ahead(2, :) - behind(2, :))/h(level)
    end do
    F(1, :) = F(1, :) + 1
    F(4, :) = F(4, :) + 1
    call must(plumb_error(plate, plumb_f, X, 0.3_c_double*period, F, weights, norms))
    error(level) = norms%l2
  end do
  call must(plumb_fit_order(h, error, fit, declared=2.0_c_double))
  print '(a, a, f8.4, a, f8.4, a, f8.4, a, a)', plumb_version(), ": order", fit%order, " [", fit%lower, ",", fit%upper, "], ", &
    fit%verdict
  if (plumb_set(plate, "amplitude", -1.0_c_double) /= plumb_bad_input) error stop 1
  print '(a, a)', "refused: ", plumb_message()
  call plumb_free(plate)
  if (fit%verdict /= "pass") error stop 1

contains
  subroutine must(status)
    integer(c_int), intent(in) :: status
    if (status == plumb_ok) return
    print '(a)', plumb_message()
    error stop 1
  end subroutine
end program
