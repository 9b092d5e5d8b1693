/** How far a ghost stands beside the robot [m]: in a row behind it, away from where the camera is at first. */
export function ghostPlace(index: number, track: number): number {
  return -index * track * 1.55;
}
