"""A robot as MuJoCo's model file (MJCF), every number from the `Robot`.

Frames: the floor is z = 0, the body's frame sits at the middle of the axle with x forward, y left, z up.
"""

from __future__ import annotations

from upright.errors import InvalidRobot
from upright.physics.dynamics import motor_gain
from upright.robots import Robot

_DIAMETRAL = 0.501  # J_d / J_w: that of a disc is 1/2, and MuJoCo refuses less than half; the rest is margin
_WIDTH = 0.25  # half width of a wheel, per radius: a point touches the floor, so this shows only in pictures

_STICK = 0.9999  # impedance of the joints' dry friction, MuJoCo's hardest: less would let a stuck joint creep

# Why contacts have this impedance and this ratio: docs/model.md.
_TEMPLATE = """\
<mujoco model="{name}">
  <compiler angle="radian" autolimits="true"/>
  <option timestep="{timestep}" gravity="0 0 {down}" integrator="implicitfast" cone="elliptic" impratio="10.0"
          solver="Newton" tolerance="1e-12" iterations="50">
    <flag autoreset="disable"/>
  </option>
  <default>
    <geom solref="{contact_time} 1" solimp="0.95 0.95 0.001" contype="0" conaffinity="1"/>
    <joint axis="0 1 0" damping="{damping}" armature="{armature}" frictionloss="{frictionloss}"
           solreffriction="{contact_time} 1" solimpfriction="{stick}"/>
  </default>
  <worldbody>
    <geom name="floor" type="plane" size="0 0 1" contype="1" conaffinity="0" condim="3" friction="0.5 0 0"/>
    <body name="body" pos="0 0 {radius}">
      <freejoint name="base"/>
      <inertial pos="0 0 {com_height}" mass="{body_mass}" diaginertia="{roll} {pitch} {yaw}"/>
      <geom name="hull" type="box" pos="0 0 {hull_middle}" size="{half_depth} {half_width} {half_height}" condim="3"
            friction="0.5 0 0"/>
      <site name="axle"/>
      <body name="left" pos="0 {half_track} 0">{wheel_left}</body>
      <body name="right" pos="0 -{half_track} 0">{wheel_right}</body>
    </body>
  </worldbody>
  <actuator>
    <general name="left" joint="left" gainprm="{gain}" biastype="affine" biasprm="0 0 {bias}"/>
    <general name="right" joint="right" gainprm="{gain}" biastype="affine" biasprm="0 0 {bias}"/>
  </actuator>
  <sensor>
    <gyro name="gyro" site="axle"/>
    <accelerometer name="accelerometer" site="axle"/>
  </sensor>
</mujoco>
"""

_WHEEL = """
        <joint name="{side}" type="hinge"/>
        <inertial pos="0 0 0" mass="{mass}" diaginertia="{diametral} {axial} {diametral}"/>
        <geom name="{side}" type="ellipsoid" size="{radius} {width} {radius}" condim="3" friction="{grip} 0 0"
              priority="1"/>
      """


def mjcf(robot: Robot, *, timestep: float, contact_time: float, grip: float) -> str:
    """The MJCF text of `robot` for steps of `timestep` [s] and contacts that settle in `contact_time` [s].

    Each wheel is an ellipsoid, which touches the floor in one point below its middle: a cylinder touches along
    its width and resists turning. The rotor's inertia n² J_m is the joint's armature, the back EMF
    the actuator's bias, so that both act on the rate between wheel and body, as in the model.
    Raises `InvalidRobot` when less is left of the body's inertias, without the wheels', than a rigid body has.
    """
    diametral = _DIAMETRAL * robot.wheel_inertia
    roll, yaw = robot.roll_inertia - 2 * diametral, robot.yaw_inertia - 2 * diametral
    _check_body(robot, roll, yaw)
    top = robot.com_height + robot.body_height / 2
    gain = motor_gain(robot)
    return _TEMPLATE.format(
        name=_escaped(robot.name),
        timestep=timestep,
        contact_time=contact_time,
        stick=f"{_STICK} {_STICK} 0.001",
        down=-robot.gravity,
        damping=robot.motor_friction,
        armature=robot.gear_ratio**2 * robot.rotor_inertia,
        frictionloss=robot.coulomb_friction,
        radius=robot.wheel_radius,
        com_height=robot.com_height,
        body_mass=robot.body_mass,
        roll=roll,
        pitch=robot.pitch_inertia,
        yaw=yaw,
        hull_middle=top / 2,  # from the axle up, so that it stays clear of the floor while the robot stands
        half_height=top / 2,
        half_depth=robot.body_depth / 2,
        half_width=robot.track / 4,
        half_track=robot.track / 2,
        wheel_left=_wheel(robot, "left", diametral, grip),
        wheel_right=_wheel(robot, "right", diametral, grip),
        gain=gain,
        bias=-gain * robot.back_emf,
    )


def _wheel(robot: Robot, side: str, diametral: float, grip: float) -> str:
    return _WHEEL.format(
        side=side,
        mass=robot.wheel_mass,
        axial=robot.wheel_inertia,
        diametral=diametral,
        radius=robot.wheel_radius,
        width=_WIDTH * robot.wheel_radius,
        grip=grip,
    )


def _check_body(robot: Robot, roll: float, yaw: float) -> None:
    smallest, middle, largest = sorted((roll, robot.pitch_inertia, yaw))
    if smallest <= 0 or largest > (smallest + middle) * (1 + 1e-9):
        raise InvalidRobot(
            f"{robot.name}: without the wheels' own inertias the body has pitch, yaw, roll inertias "
            f"{robot.pitch_inertia:.4g}, {yaw:.4g}, {roll:.4g} kg m²",
            expected="positive ones, none above the sum of the other two, for a rigid body in the twin",
            likely="yaw_inertia and roll_inertia given without the wheels'",
        )


def _escaped(name: str) -> str:
    return name.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
