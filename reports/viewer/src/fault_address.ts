import { address } from "./address";
import type { Cluster } from "./data";
import type { Run } from "./run";

const names = new WeakMap<Run, string[]>();

const slug = ({ title, has_outgrown }: Cluster): string => {
  const words = title.toLowerCase().normalize("NFKD").replace(/[’']/g, "").match(/[a-z0-9]+/g) ?? [];
  return [...words, ...(has_outgrown ? ["larger"] : [])].join("-").slice(0, 90).replace(/-$/, "") || "fault";
};

/** The names of all faults in addresses. They are the titles, which stay the same in the next run; ranks do not. If two faults have the same title, the
 * name of the second ends with its oracle. If that is the same too, it ends with a number. */
function namesOf(run: Run): string[] {
  const known = names.get(run);
  if (known) return known;
  const { clusters, oracles } = run.report;
  const used = new Set<string>();
  const list = clusters.map((cluster) => {
    const stem = slug(cluster);
    const oracle = (oracles[cluster.oracles[0]]?.name ?? "").replace(/[^a-z0-9]+/gi, "-");
    let name = used.has(stem) ? `${stem}-${oracle}` : stem;
    for (let i = 2; used.has(name); ++i) name = `${stem}-${oracle}-${i}`;
    used.add(name);
    return name;
  });
  names.set(run, list);
  return list;
}

export const faultName = (run: Run, cluster: number): string => namesOf(run)[cluster] ?? String(cluster);

/** The fault of a name; a number is the rank from 0 on, as in older addresses. −1 for none. */
export function faultOf(run: Run, name: string): number {
  const found = namesOf(run).indexOf(name);
  return found < 0 && /^\d+$/.test(name) && run.report.clusters[Number(name)] ? Number(name) : found;
}

export const faultAddress = (run: Run, cluster: number): string => address(["f", faultName(run, cluster)]);
