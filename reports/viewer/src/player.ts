import { prefersReducedMotion } from "./dom";

/** A clock that the reader starts and stops. */
export interface Player {
  playing(): boolean;
  toggle(): void;
  stop(): void;
  /** Goes to a time and tells it. */
  seek(time: number): void;
  time(): number;
  speed: number;
}

/** @param tell called with each new time, and whether the clock runs
 *  @param jumps whether a reader who asked for less motion sees the end at once, as for a short animation */
export function makePlayer(start: number, end: number, tell: (time: number, playing: boolean) => void, jumps: boolean): Player {
  let now = start;
  let frame = 0;
  let last = 0;
  const player: Player = {
    speed: 1,
    playing: () => frame !== 0,
    time: () => now,
    toggle() {
      if (frame) { player.stop(); return; }
      if (now >= end) now = start;
      if (jumps && prefersReducedMotion()) { player.seek(end); return; }
      last = performance.now();
      frame = requestAnimationFrame(tick);
      tell(now, true);
    },
    stop() {
      if (!frame) return;
      cancelAnimationFrame(frame);
      frame = 0;
      tell(now, false);
    },
    seek(time) {
      now = Math.max(start, Math.min(end, time));
      tell(now, frame !== 0);
    },
  };
  const tick = (stamp: number): void => {
    now = Math.min(end, now + (Math.max(0, stamp - last) / 1000) * player.speed);
    last = stamp;
    frame = now < end ? requestAnimationFrame(tick) : 0;
    tell(now, frame !== 0);
  };
  return player;
}
