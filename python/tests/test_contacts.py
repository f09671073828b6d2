"""Contact questions and their answers."""

import unittest

import numpy as np
from conversation import ask, ball, body, contact, contact_in_frame, frame_of

from touchstone_oracle import (
    Contact,
    ContactPoint,
    ConvexHull,
    Oracle,
    Sphere,
    Unsupported,
)

NAN = float("nan")


class Says(Oracle):
    """An oracle that always says the same, or raises it."""

    def __init__(self, what):
        self.what = what

    def contact(self, A, B):
        if isinstance(self.what, Exception):
            raise self.what
        return self.what


class Hears(Oracle):
    """An oracle that remembers the question."""

    def contact(self, A, B):
        self.A, self.B = A, B
        return Contact(touching=False)


FULL = Contact(
    touching=np.bool_(True),
    separation=np.float32(-0.5),
    normal=np.array([0, 0, 1]),
    points=[
        ContactPoint((1, 2, 3), np.array(-0.25)),
        ContactPoint(np.array([4.0, 5.0, 6.0]), -0.5, normal=[0, 1, 0]),
    ],
    witnesses=np.arange(6).reshape(2, 3),
)


class Answers(unittest.TestCase):
    def test_have_all_fields_in_json_whatever_the_types_of_their_numbers(self):
        self.assertEqual(
            contact(Says(FULL)),
            {
                "touching": True,
                "separation": -0.5,
                "normal": [0.0, 0.0, 1.0],
                "points": [
                    {"position": [1.0, 2.0, 3.0], "separation": -0.25},
                    {"position": [4.0, 5.0, 6.0], "separation": -0.5, "normal": [0.0, 1.0, 0.0]},
                ],
                "witnesses": [[0.0, 1.0, 2.0], [3.0, 4.0, 5.0]],
            },
        )

    def test_have_the_same_fields_in_a_frame(self):
        line, frame = contact_in_frame(Says(FULL), ball(0), ball(1))
        self.assertEqual(line, {"id": 1, "count": 1, "frame": 8 * len(frame)})
        head = [0, 1, 7, 0, 0, 1, -0.5, 0, 1, 2, 3, 4, 5, 2]
        points = [1, 2, 3, -0.25, 0, 0, 0, 0] + [4, 5, 6, -0.5, 1, 0, 1, 0]
        self.assertEqual(frame.tolist(), head + points)

    def test_leave_out_what_is_not_given(self):
        self.assertEqual(contact(Says(Contact(touching=False))), {"touching": False})
        _, frame = contact_in_frame(Says(Contact(touching=False)), ball(0), ball(1))
        self.assertEqual(frame.tolist(), 14 * [0.0])

    def test_pass_nan_and_infinity_on(self):
        says = Says(Contact(touching=True, separation=NAN, normal=[NAN, np.inf, -np.inf]))
        answer = contact(says)
        self.assertEqual(answer["separation"], "NaN")
        self.assertEqual(answer["normal"], ["NaN", "Infinity", "-Infinity"])
        _, frame = contact_in_frame(says, ball(0), ball(1))
        np.testing.assert_equal(frame[3:7], [NAN, np.inf, -np.inf, NAN])

    def test_are_unsupported_with_the_reason(self):
        says = Says(Unsupported("no cones"))
        self.assertEqual(contact(says), {"unsupported": "no cones"})
        line, frame = contact_in_frame(says, ball(0), ball(1))
        self.assertEqual(line["reasons"], {"0": "no cones"})
        self.assertEqual(frame.tolist(), [1.0] + 13 * [0.0])

    def test_are_an_error_if_the_engine_raises(self):
        says = Says(ValueError("no way out"))
        with self.assertLogsToStandardError("no way out"):
            self.assertEqual(contact(says), {"error": "ValueError: no way out"})
            line, frame = contact_in_frame(says, ball(0), ball(1))
        self.assertEqual(line["reasons"], {"0": "ValueError: no way out"})
        self.assertEqual(frame[0], 2.0)

    def test_say_what_is_wrong_with_them(self):
        point = ContactPoint([0, 0], -1)
        for what, error in (
            (Contact(True, normal=[1, 2]), "normal of shape (2,); expected 3 numbers"),
            (Contact(True, normal="up"), "normal of type str; expected 3 numbers"),
            (Contact(True, [1.0]), "separation of type list; expected a number"),
            (Contact(True, np.zeros(1)), "separation of shape (1,); expected a number"),
            (Contact(True, points=[point]), "points[0].position of shape (2,); expected 3 numbers"),
            (Contact(True, points=[3]), "points[0] of type int; expected a ContactPoint"),
            (Contact(True, points=point), "points of type ContactPoint; expected a list"),
            (Contact(True, witnesses=[1]), "witnesses that are not two points"),
            (Contact(None), "touching of type NoneType; expected True or False"),
            (None, "NoneType; expected a Contact"),
        ):
            with self.subTest(error):
                self.assertEqual(contact(Says(what)), {"error": "contact() returned " + error})

    def test_fail_one_by_one(self):
        class Picky(Oracle):
            def contact(self, A, B):
                return Contact(touching=True, normal=[1, 0, 0][: int(B.shape.radius)])

        queries = [(ball(0), ball(1, radius)) for radius in (3.0, 2.0, 3.0)]
        listed = [{"A": A, "B": B} for A, B in queries]
        line, _ = ask(Picky(), {"id": 1, "method": "contact", "queries": listed})
        self.assertEqual(["error" in answer for answer in line["answers"]], [False, True, False])
        message = {"id": 1, "method": "contact", "count": 3}
        line, frame = ask(Picky(), message, frame_of(queries))
        self.assertEqual(list(line["reasons"]), ["1"])
        self.assertEqual(frame.reshape(3, 14)[:, 0].tolist(), [0, 2, 0])

    def assertLogsToStandardError(self, text):
        return _StandardError(self, text)


class Questions(unittest.TestCase):
    def test_are_the_same_in_both_forms(self):
        tetrahedron = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
        A = body("convex_hull", vertices=tetrahedron)
        A["rotation"] = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
        for B in (
            ball(3.0, 0.1),
            body("box", half_extents=[1.0, 2.0, 3.0]),
            body("capsule", radius=1.0, half_length=2.0),
            body("cylinder", radius=1.0, half_length=2.0),
            body("cone", radius=1.0, half_height=2.0),
            body("half_space", position=[1.0, 2.0, 3.0]),
        ):
            with self.subTest(B["shape"]):
                in_json, in_frame = Hears(), Hears()
                contact(in_json, A, B)
                contact_in_frame(in_frame, A, B)
                self.assertIsInstance(in_json.A.shape, ConvexHull)
                for one, other in ((in_json.A, in_frame.A), (in_json.B, in_frame.B)):
                    self.assertEqual(one.shape.kind, other.shape.kind)
                    for key in ("position", "rotation", "quaternion"):
                        np.testing.assert_array_equal(getattr(one, key), getattr(other, key))
                    for key, value in vars(one.shape).items():
                        np.testing.assert_array_equal(value, getattr(other.shape, key))

    def test_have_rows_of_the_matrix(self):
        hears = Hears()
        A = ball(0)
        A["rotation"] = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
        for ask_it in (contact, contact_in_frame):
            ask_it(hears, A, ball(1))
            self.assertIsInstance(hears.A.shape, Sphere)
            self.assertEqual(hears.A.to_world(np.array([1.0, 0.0, 0.0])).tolist(), [0, 1, 0])

    def test_cannot_be_changed(self):
        hears = Hears()
        for ask_it in (contact, contact_in_frame):
            ask_it(hears, ball(0), ball(1))
            with self.assertRaises(ValueError):
                hears.A.position[0] = 1.0

    def test_of_a_frame_that_is_too_short_or_too_long_are_an_error(self):
        message = {"id": 1, "method": "contact", "count": 1}
        whole = frame_of([(ball(0), ball(1))])
        for frame in (whole[:-16], whole + bytes(8)):
            with _StandardError(self, "a frame of"):
                line, _ = ask(Hears(), message, frame)
            self.assertIn("ValueError: a frame of", line["error"])


class _StandardError:
    """Keeps standard error quiet, and expects a text in it."""

    def __init__(self, test, text):
        self.test, self.text = test, text

    def __enter__(self):
        import contextlib
        import io

        self.caught = io.StringIO()
        self.redirection = contextlib.redirect_stderr(self.caught)
        self.redirection.__enter__()

    def __exit__(self, *exception):
        self.redirection.__exit__(*exception)
        self.test.assertIn(self.text, self.caught.getvalue())


if __name__ == "__main__":
    unittest.main()
