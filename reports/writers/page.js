"use strict";
const bar = document.getElementById("filter");
const text = document.getElementById("text");
const oracle = document.getElementById("oracle");
const verdict = document.getElementById("verdict");
const count = document.getElementById("count");
const scenarios = [...document.querySelectorAll("details.scenario")];

// The height of the filter bar depends on the rows of its controls. A link must scroll its
// target to below the bar.
function clearOfBar() {
  const sticky = getComputedStyle(bar).position === "sticky";
  document.documentElement.style.scrollPaddingTop = sticky ? `${bar.offsetHeight + 8}px` : "0";
}

// data-outcomes holds one verdict per oracle, in the order of the oracle list.
function matches(scenario) {
  const words = text.value.toLowerCase().split(/\s+/).filter(Boolean);
  if (!words.every((word) => scenario.dataset.text.includes(word))) return false;
  if (!verdict.value) return true;
  const outcomes = scenario.dataset.outcomes.split(" ");
  const asked = oracle.value === "" ? outcomes : [outcomes[Number(oracle.value)]];
  const wanted = verdict.value.split(" ");
  return asked.some((outcome) => wanted.includes(outcome));
}

function filter() {
  let shown = 0;
  for (const scenario of scenarios) {
    scenario.hidden = !matches(scenario);
    if (!scenario.hidden) ++shown;
  }
  count.textContent = `${shown} of ${scenarios.length}`;
  clearOfBar();
}

// Opens the scenario that a link leads to.
function openTarget() {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (target instanceof HTMLDetailsElement) {
    target.hidden = false;
    target.open = true;
    target.scrollIntoView();
  }
}

for (const control of [text, oracle, verdict]) control.addEventListener("input", filter);
bar.addEventListener("submit", (event) => event.preventDefault());
window.addEventListener("hashchange", openTarget);
window.addEventListener("resize", clearOfBar);
filter();
openTarget();
