# SPDX-License-Identifier: LGPL-2.1-or-later
"""What accuracy.csv must tell where the answer is known."""

# Estimates may be off by so much, either way.
FACTOR = 5.0
# Errors that fall by more from one level to the next are overestimated on purpose: no gain above 400 is believed.
GREATEST_GAIN = 1000


def levels(run, quantity):
    """(value, estimated relative error) of the levels."""
    return [(float(row[quantity]), float(row["estimated_relative_error"])) for row in run.table("accuracy.csv")]


def check_levels(test, run, quantity, reference, digits):
    """Estimates against true errors, as far as the reference's relative accuracy `digits` goes.

    No error is above FACTOR times its estimate. Where errors fall and keep their sign, from the level before and to the next one, no estimate is
    above FACTOR times the error either.
    """
    table = levels(run, quantity)
    errors = [value / reference - 1 for value, _ in table]
    for number, (error, (_, estimate)) in enumerate(zip(errors, table)):
        test.assertLessEqual(abs(error), FACTOR * estimate + digits, f"level {number} of {table}")
        neighbours = [errors[i] for i in (number - 1, number + 1) if 0 <= i < len(errors)]
        falls = all(e * error > 0 for e in neighbours) and (number == 0 or 2 < abs(errors[number - 1] / error) < GREATEST_GAIN) and (
            number + 1 == len(errors) or abs(errors[number + 1]) < abs(error) / 2)
        if falls and abs(error) > 10 * digits:
            test.assertLessEqual(estimate, FACTOR * abs(error), f"level {number} of {table}")
    return table


def check_reached(test, run, quantity, reference, target, digits=1e-10):
    """The run ends where its estimate is below the target; so is at most the level before, where it takes the last one to estimate it."""
    table = check_levels(test, run, quantity, reference, digits)
    test.assertLessEqual(table[-1][1], target)
    test.assertTrue(all(estimate > target for _, estimate in table[:-2]), table)
    test.assertEqual(run.quantities["estimated_relative_error"], table[-1][1])
    test.assertEqual(run.quantities[quantity], table[-1][0])
