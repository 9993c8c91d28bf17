"""Shared by the tests of misbehaving users' code: four footbots, of which the last one, or a plugin, misbehaves."""

ROBOTS = ("fb_1", "fb_2", "fb_3", "fb_4")
WORLD = """<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>{maxclock}</maxclock><threads>{threads}</threads></framework>
  <controllers>
    <misbehaving id="mc" library="misbehaving_controllers">
      <actuators><footbot_wheels/></actuators>
      <parameters><phase>{phase}</phase><action>{action}</action><tick>{tick}</tick><only>{only}</only></parameters>
    </misbehaving>
  </controllers>
  <arena size="10,10,3" optimization="2D">
    {robots}
  </arena>
  <engines><kinematics2d id="ground"/></engines>
  <arena_physics><engine id="ground">{members}</engine></arena_physics><rules></rules>
  <visualisations><text_render id="table"><file>table.txt</file></text_render></visualisations>
</ahss-config>
"""
NAME = "robot 'fb_4' (controller 'mc' of libmisbehaving_controllers.so)"


def world(phase="never", action="nothing", tick=3, maxclock=20, threads=1, only="fb_4"):
    """Returns the text of an experiment file."""
    robots = "\n".join(f'<footbot id="{name}"><position>1, {1 + i}, 0</position><orientation>0, 0, 0</orientation>'
                       '<controller>mc</controller></footbot>' for i, name in enumerate(ROBOTS))
    members = "".join(f'<entity id="{name}"/>' for name in ROBOTS)
    return WORLD.format(phase=phase, action=action, tick=tick, maxclock=maxclock, threads=threads, robots=robots,
                        members=members, only=only)


# plugins other than controllers, as messages name them when one of their calls does not return
ENGINE = "engine 'bad' (misbehaving_engine)"
RULE = "rule 'bad' (misbehaving_rule)"
VISUALISATION = "visualisation 'bad' (misbehaving_visualisation)"
SENSOR = "sensor 'footbot_gripper_state' of controller 'mc'"
ACTUATOR = "actuator 'footbot_leds' of controller 'mc'"
PLACES = {  # for each, the text before it and its element
    ENGINE: ("<engines>", '<misbehaving_engine id="bad" library="misbehaving_controllers">{}</misbehaving_engine>'),
    RULE: ("<rules>", '<misbehaving_rule id="bad" library="misbehaving_controllers">{}</misbehaving_rule>'),
    VISUALISATION: ("<visualisations>", '<misbehaving_visualisation id="bad" library="misbehaving_controllers">{}'
                                        "</misbehaving_visualisation>"),
    SENSOR: ('library="misbehaving_controllers">', "<sensors><footbot_gripper_state><implementation>misbehaving"
                                                   "</implementation>{}</footbot_gripper_state></sensors>"),
    ACTUATOR: ("<actuators>", "<footbot_leds><implementation>misbehaving</implementation>{}</footbot_leds>"),
}


def world_with(who, phase, action, **more):
    """The same, but all controllers behave, and a plugin placed before all others of its kind misbehaves."""
    before, plugin = PLACES[who]
    parameters = f"<phase>{phase}</phase><action>{action}</action>"
    return world(**more).replace(before, before + plugin.format(parameters))
