"""The judgement of one of the questions beside load factors in space, which are
asked in turn."""
from judging.space_ranges import SpaceRangeJudgement
from judging.space_settlements import SpaceSettlementJudgement
from judging.space_sliding import SpaceSlidingJudgement
from judging.space_smoothed import SmoothedJudgement

IN_TURN = (SpaceRangeJudgement, SpaceSettlementJudgement, SpaceSlidingJudgement,
           SmoothedJudgement)


def scene_in_turn(seed, k):
    """That of the question of a number."""
    scene = IN_TURN[k % len(IN_TURN)].scenes(seed, k // len(IN_TURN))
    scene.judgement = IN_TURN[k % len(IN_TURN)]
    return scene


def further_judgement(program, scene, report):
    """That of the question of a scene."""
    return scene.judgement(program, scene, report)


further_judgement.scenes = scene_in_turn
