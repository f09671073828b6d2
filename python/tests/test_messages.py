"""Messages: hello, the end, and what is no message."""

import io
import unittest

from conversation import ask, line_of, say

from touchstone_oracle import (
    Capability,
    Contact,
    Documented,
    DocumentedError,
    Oracle,
    Parameter,
    Setting,
    serve,
)

HELLO = {"id": 0, "method": "hello", "protocol": 1}
BYE = {"method": "bye"}


class Balls(Oracle):
    pairs = [("sphere", "sphere")]
    gives = ["depth"]

    def contact(self, A, B):
        return Contact(touching=True)


class Hello(unittest.TestCase):
    def test_has_the_defaults_of_an_oracle_that_says_little(self):
        line, _ = ask(Balls(), HELLO)
        capability = {"pairs": [["sphere", "sphere"]], "family": "balls", "gives": ["depth"]}
        self.assertEqual(
            line,
            {
                "id": 0,
                "protocol": 1,
                "name": "balls",
                "library": "balls",
                "version": "unversioned",
                "precision": "double",
                "subtracts_first": False,
                "frames": True,
                "settings": [],
                "contact": [capability],
            },
        )

    def test_has_all_that_an_oracle_says(self):
        class Everything(Balls):
            settings = [Setting("margin", "0", "it would round edges")]
            capabilities = [
                Capability(
                    shapes=["sphere", "box"],
                    gives=["depth", "normal"],
                    family="gjk_epa",
                    documented_error=DocumentedError(1e-6, 0.0, "manual, p. 3"),
                ),
                Capability(pairs=[("box", "box")], unsupported="no boxes"),
            ]
            supports = ["sphere", "push"]
            unsupported = {"cloth": "no point masses"}
            parameters = [
                Parameter("erp", 0.0, 0.2, 0.0, float("inf"), "share of depth", "it adds energy")
            ]
            softness = "erp"
            slop = Documented(0.005, "manual, p. 4")
            sleep_speed = Documented(0.05, "manual, p. 5")
            order = Documented(2, "manual, p. 6")
            rotation_error = Documented(1e-3, "manual")

            def begin(self, world, parameters):
                raise NotImplementedError

        line, _ = ask(Everything(), HELLO)
        by = "manual, p. 3"
        self.assertEqual(
            line["contact"],
            [
                {
                    "shapes": ["sphere", "box"],
                    "family": "gjk_epa",
                    "gives": ["depth", "normal"],
                    "documented_error": {"length": 1e-6, "share": 0.0, "by": by},
                },
                {"pairs": [["box", "box"]], "unsupported": "no boxes"},
            ],
        )
        world = line["world"]
        self.assertEqual(world["supports"], ["sphere", "push"])
        self.assertEqual(world["unsupported"], {"cloth": "no point masses"})
        self.assertEqual(world["parameters"][0]["most"], "Infinity")
        self.assertEqual(world["parameters"][0]["whole"], False)
        self.assertEqual(world["softness"], "erp")
        self.assertEqual(world["slop"], {"length": 0.005, "by": "manual, p. 4"})
        self.assertEqual(world["sleep_speed"], {"speed": 0.05, "by": "manual, p. 5"})
        self.assertEqual(world["order"], {"order": 2.0, "by": "manual, p. 6"})
        self.assertEqual(world["rotation_error"], {"error": 1e-3, "by": "manual"})

    def test_refuses_an_oracle_that_answers_nothing(self):
        class Nothing(Oracle):
            pass

        line, _ = ask(Nothing(), HELLO)
        self.assertIn("Nothing defines none of contact()", line["error"])

    def test_refuses_contact_without_shapes(self):
        class Shapeless(Oracle):
            def contact(self, A, B):
                return Contact(touching=True)

        line, _ = ask(Shapeless(), HELLO)
        self.assertIn("no pairs, shapes or capabilities", line["error"])


class Conversation(unittest.TestCase):
    def test_ends_at_bye_without_an_answer(self):
        answers = say(Balls(), line_of(BYE) + line_of(HELLO))
        self.assertEqual(answers, [])

    def test_ends_at_the_end_of_the_input(self):
        self.assertEqual(len(say(Balls(), line_of(HELLO))), 1)
        self.assertEqual(say(Balls(), line_of(HELLO)[:-1]), [])
        self.assertEqual(say(Balls(), b'{"id":1,"method":"contact","count":1,"frame":8}\nabc'), [])

    def test_goes_on_after_a_malformed_message(self):
        for malformed in (b"{oops\n", b"[1]\n", b"\xff\n", b'{"frame":7}\n'):
            answers = say(Balls(), malformed + line_of(HELLO))
            self.assertIsNone(answers[0][0]["id"])
            self.assertIn("expected", answers[0][0]["error"])
            self.assertEqual(answers[1][0]["protocol"], 1)

    def test_answers_an_unknown_method_and_an_impossible_question_with_an_error(self):
        line, _ = ask(Balls(), {"id": 5, "method": "sing"})
        self.assertEqual((line["id"], "'sing'" in line["error"]), (5, True))
        query = {"A": {"shape": "torus"}, "B": {"shape": "torus"}}
        line, _ = ask(Balls(), {"id": 6, "method": "contact", "queries": [query]})
        self.assertEqual(line, {"id": 6, "error": "ValueError: unknown shape 'torus'"})

    def test_ends_when_nobody_reads(self):
        class Closed(io.BytesIO):
            def write(self, data):
                raise BrokenPipeError

        serve(Balls(), io.BytesIO(line_of(HELLO)), Closed())


if __name__ == "__main__":
    unittest.main()
