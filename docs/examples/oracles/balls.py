"""An oracle for two spheres: how deep they overlap, or how far they are apart."""

import math

from touchstone_oracle import Contact, ContactPoint, Oracle, serve

import numpy as np


class Balls(Oracle):
    name = "balls"
    library = "balls.py"
    version = "1.0"
    family = "closed_form"
    subtracts_first = True
    pairs = [("sphere", "sphere")]
    gives = ["depth", "distance", "normal", "manifold"]

    def contact(self, A, B):
        d = B.position - A.position
        # Unlike the root of d @ d, hypot() never overflows or underflows.
        distance = math.hypot(*d)
        separation = distance - (A.shape.radius + B.shape.radius)
        # Every direction is equally right for two balls with one centre.
        normal = d / distance if distance > 0 else np.array([0.0, 0.0, 1.0])
        if separation > 0:
            return Contact(touching=False, separation=separation, normal=normal)
        # Midway between the two surfaces.
        midpoint = A.position + (A.shape.radius + separation / 2) * normal
        point = ContactPoint(midpoint, separation)
        return Contact(True, separation, normal, [point])


serve(Balls())
