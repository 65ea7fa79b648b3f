'use strict';
// Where the viewer of the bodies stands: a parallel projection, as of `pinball view` (python/view/camera.py).

/// Degrees: azimuth from the side, turning towards +x; elevation above the plane of x and y.
const standardViews = {iso: [25, 25], side: [0, 0], back: [180, 0], right: [90, 0], left: [-90, 0], top: [0, 90], bottom: [0, -90]};

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

class ViewerCamera {
  azimuth = 25;
  elevation = 25;
  centre = [0, 0, 0];  ///< what is in the middle of the picture [length]
  height = 1;          ///< of the picture [length]

  /// Unit vectors to the right, up and toward the viewer.
  get axes() {
    const a = this.azimuth * Math.PI / 180, e = this.elevation * Math.PI / 180;
    return [[Math.cos(a), Math.sin(a), 0],
            [-Math.sin(a) * Math.sin(e), Math.cos(a) * Math.sin(e), Math.cos(e)],
            [Math.sin(a) * Math.cos(e), -Math.cos(a) * Math.cos(e), Math.sin(e)]];
  }

  /// All of a box along the axes is seen in a picture of that width over height, with a margin.
  fit(box, aspect) {
    const [width, height] = box.map(([low, high]) => high - low), margin = 0.08 * Math.max(width, height);
    this.height = Math.max(height + margin, (width + margin) / aspect) || 1;
    const axes = this.axes;
    this.centre = [0, 1, 2].map((c) => axes.reduce((sum, axis, a) => sum + 0.5 * (box[a][0] + box[a][1]) * axis[c], 0));
  }

  turn(right, up) {
    this.azimuth = ((this.azimuth + right + 540) % 360 + 360) % 360 - 180;
    this.elevation = Math.min(90, Math.max(-90, this.elevation + up));
  }

  /// By parts of the picture's height.
  move(right, up) {
    const [across, upward] = this.axes;
    this.centre = this.centre.map((c, i) => c + this.height * (right * across[i] + up * upward[i]));
  }

  /// What lies at (right, up) of the middle, in parts of the picture's height, stays there.
  zoom(factor, right = 0, up = 0) {
    this.move(right * (1 - 1 / factor), up * (1 - 1 / factor));
    this.height /= factor;
  }
}
