# [example]
import matplotlib.pyplot as plt
import pinball

simulation = pinball.Simulation(pinball.read_scene("two_bars"))
rows = []
simulation.on_step(lambda s: rows.append(s.history_row()))
simulation.run()
plt.plot([row.time for row in rows], [[bar.velocity[0] for bar in row.bodies] for row in rows])
plt.legend([bar.name for bar in simulation.bodies])
plt.savefig("two_bars.png")
# [example]
